// Vehicles that are alike, as far as the routes care: each shape is checked once.
#pragma once

#include <vector>

#include "floor/site.h"

namespace tessera::sitecheck {

/// The site's vehicles without those that have the same outline as an earlier one.
[[nodiscard]] std::vector<const floor::VehicleSetup*> bodiesOf(const floor::Site& site);
/// The same by readers and what they see.
[[nodiscard]] std::vector<const floor::VehicleSetup*> readerRowsOf(const floor::Site& site);

}  // namespace tessera::sitecheck
