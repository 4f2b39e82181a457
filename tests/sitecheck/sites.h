// Sites for the checks: a good floor to break in one way at a time, and floors broken at random.
#pragma once

#include <random>

#include "sitecheck/site_checker.h"

namespace tessera::sitecheck {

[[nodiscard]] inline Point at(double x, double y) { return {Metres{x}, Metres{y}}; }
[[nodiscard]] std::vector<Point> rectangle(double x0, double y0, double x1, double y1);
[[nodiscard]] floor::Zone zone(const std::string& name, floor::ZoneKind kind, std::vector<Point> outline);

/// 5 by 4 tiles of 60 cm, one running zone over them, every tag registered, one vehicle, one route without a fault.
[[nodiscard]] floor::Site goodFloor();

/// The faults of that kind.
[[nodiscard]] Faults faultsOf(const floor::Site& site, FaultKind kind);
/// All faults as codes, for messages: "tiles-overlap: Tiles ..."
[[nodiscard]] std::string listOf(const Faults& faults);

/// One edit of a kind that operators make, sometimes a bad one.
void editAtRandom(floor::Site& site, std::mt19937_64& random);

}  // namespace tessera::sitecheck
