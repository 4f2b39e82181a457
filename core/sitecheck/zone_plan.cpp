#include "sitecheck/zone_plan.h"

namespace tessera::sitecheck {

using floor::ZoneKind;

bool opensTheFloor(ZoneKind kind) {
  return kind == ZoneKind::Running || kind == ZoneKind::Storage || kind == ZoneKind::Parking ||
         kind == ZoneKind::Charging;
}

ZonePlan::ZonePlan(std::span<const floor::Zone> zones) {
  std::vector<region::Region> open;
  std::vector<region::Region> runs;
  std::vector<region::Region> forbidden;
  for (const floor::Zone& zone : zones) {
    areas.push_back(region::Region::of(zone.outline));
    if (opensTheFloor(zone.kind)) open.push_back(areas.back());
    if (zone.kind == ZoneKind::Running) runs.push_back(areas.back());
    if (zone.kind == ZoneKind::NoGo) forbidden.push_back(areas.back());
  }
  running = region::Region::unionOf(runs);
  noGo = region::Region::unionOf(forbidden);
  anyRunning = !running.empty();
  // A millimetre more closes the seams between zones that were drawn by hand, and lets a route run along an edge.
  constexpr Metres seam{0.001};
  drivable = region::Region::unionOf(open).grown(seam) - noGo.grown(-seam);
}

}  // namespace tessera::sitecheck
