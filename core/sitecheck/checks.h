// The single checks. Each is a pure function of the parts of a site that its row in site_checker.cpp names.
#pragma once

#include <span>

#include "sitecheck/fault.h"
#include "sitecheck/floor_plan.h"
#include "sitecheck/lattice.h"
#include "sitecheck/options.h"
#include "sitecheck/zone_plan.h"

namespace tessera::sitecheck {

/// A UID that stands twice. Each end is the tag of a tile, or a loose tag.
struct RepeatedUid {
  struct End {
    floor::TagUid uid;
    std::uint32_t tile = kGone;  ///< kGone: a loose tag
    std::uint32_t position = 0;  ///< in the tile's UIDs, or of the loose tag
  };
  End first;
  End later;
};
[[nodiscard]] std::vector<RepeatedUid> repeatedUids(const floor::Site& site);
/// Of each tile, how many of its tags are registered.
[[nodiscard]] std::vector<std::uint32_t> registeredTags(const floor::Site& site);

struct Context {
  const floor::Site& site;
  const CheckOptions& options;
  const FloorPlan& plan;
  const ZonePlan& zones;
  const region::BoxTree& looseTags;  ///< finds indices into the site's loose tags
  const Lattice& lattice;
  const std::vector<RepeatedUid>& repeated;
  const std::vector<std::uint32_t>& registered;
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
/// Whether tags that lie there could be seen from the route by any vehicle, or it is too long to tell.
[[nodiscard]] bool passesNear(const Context& context, const floor::Route& route, std::span<const Box> places);

}  // namespace tessera::sitecheck
