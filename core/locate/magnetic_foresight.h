// How a compass' error will change along the way, by the magnetic map: it follows the floor as slowly as the vehicle's
// heading follows its compass, and what the map does not know wanders about that.
#pragma once

#include <optional>

#include "base/pose.h"
#include "locate/magnetic_map.h"

namespace tessera::locate {

class MagneticForesight {
public:
  struct Step {
    double shift = 0.0;   ///< rad, expected change of the error
    double wander = 0.0;  ///< rad/√m, what may come on top
    double pull = 0.0;    ///< share of its distance from `toward` that the error loses
    double toward = 0.0;  ///< rad, what the map and the vehicle's own part say
  };
  /// Over a way that ends at `place`. outlook.map must be there. unknown: rad/√m, where the map knows nothing.
  [[nodiscard]] Step over(const MagneticOutlook& outlook, Point place, double way, double seconds, double unknown);

private:
  std::optional<double> followed_;  ///< rad, the floor's part in the heading; none before the first step
  Point last_;
};

}  // namespace tessera::locate
