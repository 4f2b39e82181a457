// The ways that the site's vehicles take along a line whose corners they round.
#pragma once

#include <vector>

#include "base/polyline.h"
#include "sitecheck/checks.h"

namespace tessera::sitecheck {

/// Around a vertex of the line drawn; the two halves of the arc meet where it is nearest to the vertex.
struct RoundCorner {
  std::size_t vertex;  ///< of the line drawn, from 0
  Polyline before;
  Polyline behind;
  Box box;  ///< around both
};

struct RoundWay {
  const floor::VehicleSetup* vehicle;  ///< the first of those that take it; the site's, or floor::usualVehicle()
  Polyline whole;
  std::vector<RoundCorner> corners;  ///< in the order of the line; never empty
};

/// One for each corner cut among the vehicles, without those that round none of the line's corners.
[[nodiscard]] std::vector<RoundWay> roundWaysOf(const Context& context, const Polyline& line);

}  // namespace tessera::sitecheck
