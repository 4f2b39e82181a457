// How quickly places are being registered, and how long the rest will take.
#pragma once

#include <deque>
#include <optional>

#include "base/units.h"

namespace tessera::scan {

class Pace {
public:
  static constexpr std::size_t kRemembered = 30;  ///< tags that the pace is taken from
  static constexpr Seconds kLongestBreath{30.0};  ///< a longer time between two tags was a pause

  void registered(Seconds now);
  /// The next tag's time does not count from the last one's.
  void pause() { last_.reset(); }
  /// Nullopt: too few tags yet.
  [[nodiscard]] std::optional<Seconds> perTag() const;
  [[nodiscard]] std::optional<Seconds> timeFor(std::size_t tags) const;

private:
  std::optional<Seconds> last_;
  std::deque<Seconds> took_;
};

}  // namespace tessera::scan
