// The vehicle numbers its tag events; the host says which it wants next. Repeats are dropped, gaps are counted, ages
// become instants.
#pragma once

#include <cstdint>
#include <vector>

#include "base/units.h"
#include "wire/messages.h"

namespace tessera::link {

/// A tag event with its instant on the host's clock.
struct TimedTagEvent {
  wire::TagEvent event;
  Seconds at;          ///< of the read; for Left of the last good read
  bool older = false;  ///< the age was beyond what the wire can tell: `at` is an upper limit
};

class TagStream {
public:
  struct Taken {
    std::vector<TimedTagEvent> fresh;  ///< in the order in which they happened
    unsigned lost = 0;                 ///< events between the last one known and the first one told
  };

  /// Number of the first event that is still wanted; for CycleEntry::nextEvent.
  [[nodiscard]] std::uint8_t next() const { return next_; }
  /// The vehicle has started anew: it numbers from zero again.
  void restart() {
    next_ = 0;
    synchronous_ = false;
  }
  /// sampledAt: when the report was made, by the host's clock.
  [[nodiscard]] Taken take(const wire::Report& report, Seconds sampledAt);

private:
  std::uint8_t next_ = 0;
  bool synchronous_ = false;  ///< false: no report since the start; its numbers are taken as they come
};

}  // namespace tessera::link
