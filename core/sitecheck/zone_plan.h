// Zones as areas, derived once for all checks, by the rules of docs/site-format.md for zones that lie upon one another.
#pragma once

#include <span>
#include <vector>

#include "floor/site.h"
#include "region/region.h"

namespace tessera::sitecheck {

/// Where vehicles may be, unless it is no-go as well: running, storage, parking, charging.
[[nodiscard]] bool opensTheFloor(floor::ZoneKind kind);

struct ZonePlan {
  ZonePlan() = default;
  explicit ZonePlan(std::span<const floor::Zone> zones);

  std::vector<region::Region> areas;  ///< of each zone
  region::Region running;
  region::Region noGo;
  /// Where vehicles may be: zones that open the floor, less no-go. Zones drawn to the same line are one area.
  region::Region drivable;
  bool anyRunning = false;
};

}  // namespace tessera::sitecheck
