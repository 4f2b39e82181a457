// What the zones say to a route: to the line drawn, and to the ways of the vehicles that round its corners.
#pragma once

#include <vector>

#include "base/polyline.h"
#include "sitecheck/checks.h"

namespace tessera::sitecheck {

struct ZoneVerdict {
  Faults faults;
  bool lineOnFloor = true;        ///< the line drawn is where vehicles may be
  std::vector<Metres> cutsOffIt;  ///< the corner cuts whose ways leave it all the same
  [[nodiscard]] bool isOnFloor(const floor::VehicleSetup& vehicle) const;
};

/// `line`: the route's, without repeated points; at least one leg. A zone that the line breaks is told of the line
/// alone; what only the way round a corner breaks is told of the first vehicle of each corner cut.
[[nodiscard]] ZoneVerdict zoneVerdictOf(const Context& context, const floor::Route& route, const Polyline& line);

}  // namespace tessera::sitecheck
