#include "supervisor/site_change.h"

#include <algorithm>

namespace tessera::supervisor {

bool sameFleet(const floor::RadioSetup& radio, const std::vector<floor::VehicleSetup>& vehicles,
               const floor::Site& after) {
  if (radio != after.radio || vehicles.size() != after.vehicles.size()) return false;
  return std::all_of(vehicles.begin(), vehicles.end(), [&](floor::VehicleSetup was) {
    const auto is = std::find_if(after.vehicles.begin(), after.vehicles.end(),
                                 [&](const floor::VehicleSetup& v) { return v.id == was.id; });
    if (is == after.vehicles.end()) return false;
    was.name = is->name;
    was.start = is->start;
    return was == *is;
  });
}

}  // namespace tessera::supervisor
