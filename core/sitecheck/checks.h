// The single checks. Each is a pure function of the parts of a site that its row in site_checker.cpp names.
#pragma once

#include "sitecheck/fault.h"
#include "sitecheck/floor_plan.h"
#include "sitecheck/options.h"
#include "sitecheck/zone_plan.h"

namespace tessera::sitecheck {

struct Context {
  const floor::Site& site;
  const CheckOptions& options;
  const FloorPlan& plan;
  const ZonePlan& zones;
  const region::BoxTree& looseTags;  ///< finds indices into the site's loose tags
};

[[nodiscard]] Faults checkTileNames(const Context& context);
[[nodiscard]] Faults checkTwins(const Context& context);
[[nodiscard]] Faults checkUids(const Context& context);
[[nodiscard]] Faults checkRegistration(const Context& context);
[[nodiscard]] Faults checkLattice(const Context& context);
[[nodiscard]] Faults checkZoneShapes(const Context& context);
[[nodiscard]] Faults checkZoneStacking(const Context& context);
[[nodiscard]] Faults checkReach(const Context& context);
[[nodiscard]] Faults checkRouteNames(const Context& context);
[[nodiscard]] Faults checkVehicles(const Context& context);
[[nodiscard]] Faults checkStarts(const Context& context);
[[nodiscard]] Faults checkRadio(const Context& context);
[[nodiscard]] Faults checkEmpty(const Context& context);

// Of one zone alone, by its index.
[[nodiscard]] Faults checkGaps(const Context& context, std::size_t zone);
// Of one route alone, whether it is among the site's or not.
[[nodiscard]] Faults checkRouteWay(const Context& context, const floor::Route& route);
/// Gives the faults of a route's way the edits that mend them, where trying shows that they do.
void offerRouteFixes(const Context& context, const floor::Route& route, Faults& faults);
[[nodiscard]] Faults checkRouteTags(const Context& context, const floor::Route& route);

}  // namespace tessera::sitecheck
