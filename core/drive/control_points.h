// The publication's control points: along each leg of a route every d metres, ending on each vertex.
#pragma once

#include <vector>

#include "base/polyline.h"
#include "base/result.h"

namespace tessera::drive {

struct ControlPoint {
  Point place;
  Metres along;  ///< distance from the route's start
  bool vertex = false;
};

/// p_n = P0 + n·d·(P1 − P0)/|P1 − P0| on every leg, from the route's first point to its last. The last interval of a
/// leg is what remains, and is merged with the one before when shorter than d/4. Error: spacing not a positive number,
/// a route of fewer than two different points, or more than 100 000 points.
[[nodiscard]] Result<std::vector<ControlPoint>> controlPoints(const Polyline& route, Metres spacing);

}  // namespace tessera::drive
