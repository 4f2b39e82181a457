// Unwraps the vehicle's odometer, which counts millimetres modulo 65536 and begins anew when the vehicle does.
#pragma once

#include <cstdint>

#include "base/units.h"

namespace tessera::supervisor {

class Odometer {
public:
  /// The vehicle has started anew: the next count is a new beginning, the way travelled stays.
  void restart() { known_ = false; }
  /// Returns the way travelled since the first count ever, forwards minus backwards.
  Metres add(std::uint16_t millimetres) {
    if (known_) travelled_ += static_cast<std::int16_t>(static_cast<std::uint16_t>(millimetres - last_));
    last_ = millimetres;
    known_ = true;
    return Metres{static_cast<double>(travelled_) / 1000.0};
  }

private:
  std::int64_t travelled_ = 0;
  std::uint16_t last_ = 0;
  bool known_ = false;
};

}  // namespace tessera::supervisor
