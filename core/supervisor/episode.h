// A condition that lasts is told twice: when it begins and when it is over. In between nothing, however often it is
// seen; and it is over only when it has not been seen for a while, so that a flickering one makes no storm.
#pragma once

#include <cstdint>

#include "base/units.h"

namespace tessera::supervisor {

class Episode {
public:
  enum class Change { None, Begins, Ends };

  explicit Episode(Seconds quiet = Seconds{0.0}) : quiet_{quiet} {}
  /// To be called whenever the condition may have been seen; `count` of sightings are added up. Begins at the first.
  Change seen(Seconds now, std::uint32_t count = 1) {
    last_ = now;
    const bool begins = !active_;
    count_ = begins ? count : count_ + count;
    active_ = true;
    return begins ? Change::Begins : Change::None;
  }
  /// To be called when it was not seen, or from time to time.
  Change notSeen(Seconds now) {
    if (!active_ || now < last_ + quiet_) return Change::None;
    active_ = false;
    return Change::Ends;
  }
  Change update(bool condition, Seconds now) { return condition ? seen(now) : notSeen(now); }
  [[nodiscard]] bool active() const { return active_; }
  /// Sightings in this episode, or in the last one.
  [[nodiscard]] std::uint32_t count() const { return count_; }
  /// Ends without a word, because something greater explains it.
  void forget() { active_ = false; }

private:
  Seconds quiet_;
  Seconds last_{0.0};
  std::uint32_t count_ = 0;
  bool active_ = false;
};

}  // namespace tessera::supervisor
