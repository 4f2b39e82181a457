// What may change of a site while its vehicles are supervised, and what of it they notice.
#pragma once

#include "floor/site_map.h"

namespace tessera::supervisor {

/// Whether supervision can go on with the new site: the same radio and the same vehicles. Their names and start places
/// may differ.
[[nodiscard]] bool sameFleet(const floor::RadioSetup& radio, const std::vector<floor::VehicleSetup>& vehicles,
                             const floor::Site& after);

}  // namespace tessera::supervisor
