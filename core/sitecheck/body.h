// Vehicles that are alike, as far as the routes care: each shape is checked once. A site without vehicles is checked
// for a usual one: its routes are drawn before its vehicles are set up.
#pragma once

#include <vector>

#include "floor/site.h"
#include "sitecheck/fault.h"

namespace tessera::sitecheck {

/// The site's vehicles without those that have the same outline, speeds and corners as an earlier one;
/// floor::usualVehicle() if it has none.
[[nodiscard]] std::vector<const floor::VehicleSetup*> bodiesOf(const floor::Site& site);
/// The same by readers and what they see.
[[nodiscard]] std::vector<const floor::VehicleSetup*> readerRowsOf(const floor::Site& site);
/// None of the site's, but the usual one.
[[nodiscard]] bool isUsual(const floor::VehicleSetup& vehicle);
/// "vehicle "AGV 1"", within a sentence.
[[nodiscard]] Sentence nameOf(const floor::VehicleSetup& vehicle);
/// Names it among a route fault's objects, behind the route; the usual one has no name to go by.
void addTo(std::vector<Object>& objects, const floor::VehicleSetup& vehicle);
/// Whether a route's fault, with objects as addTo leaves them, is this vehicle's.
[[nodiscard]] bool isOf(const Fault& fault, const floor::VehicleSetup& vehicle);

}  // namespace tessera::sitecheck
