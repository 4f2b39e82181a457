// The highest speeds of a route's legs, by the distance from the route's start.
#pragma once

#include <vector>

#include "drive/speed_plan.h"

namespace tessera::drive {

class LegLimits {
public:
  explicit LegLimits(const floor::Route& route);

  /// What the legs allow at a distance, where the place is known to within `doubt`: the limit of every leg on which the
  /// vehicle may be, and so much before a slower one that it has slowed down where that begins. `from`: legs that end
  /// before this distance are not driven at all. `delay` is what a command holds on for at least.
  [[nodiscard]] SpeedLimit at(Metres along, Metres doubt, Seconds delay, const SpeedPlan& plan, Metres from = {}) const;

private:
  struct Stretch {
    Metres from;
    Metres to;
    MetresPerSecond speed;
  };
  std::vector<Stretch> stretches_;  ///< in their order, of legs that have a speed
};

}  // namespace tessera::drive
