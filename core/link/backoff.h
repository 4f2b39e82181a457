// When to try again: soon at first, then ever more rarely, never rarer than a limit.
#pragma once

#include <algorithm>

#include "base/units.h"

namespace tessera::link {

class Backoff {
public:
  Backoff(Seconds first, Seconds limit) : first_{first}, limit_{limit}, pause_{first} {}
  [[nodiscard]] bool due(Seconds now) const { return now >= next_; }
  [[nodiscard]] Seconds next() const { return next_; }
  void failed(Seconds now) {
    next_ = now + pause_;
    pause_ = std::min(2.0 * pause_, limit_);
  }
  /// Something gave hope: try at once, and quickly again.
  void reset(Seconds now) {
    next_ = now;
    pause_ = first_;
  }

private:
  Seconds first_;
  Seconds limit_;
  Seconds pause_;
  Seconds next_{0.0};
};

}  // namespace tessera::link
