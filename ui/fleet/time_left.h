// "About so long left", from an estimate that jumps: a vehicle that turns or brakes needs no longer because of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace tessera::ui {

class TimeLeft {
public:
  static constexpr int kStep = 5;  ///< s

  /// Whole steps, at least one. It falls as the estimate does, and rises only where that is a tenth above it.
  int shown(double estimate) {
    const int steps = std::max(1, static_cast<int>(std::lround(estimate / kStep)));
    const int now = kStep * steps;
    if (!shown_ || now < *shown_ || (now > *shown_ && estimate > 1.1 * *shown_)) shown_ = now;
    return *shown_;
  }
  void reset() { shown_.reset(); }

private:
  std::optional<int> shown_;
};

}  // namespace tessera::ui
