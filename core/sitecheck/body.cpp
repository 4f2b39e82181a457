#include "sitecheck/body.h"

#include <algorithm>

namespace tessera::sitecheck {
namespace {

template <class Alike>
std::vector<const floor::VehicleSetup*> withoutLikes(const floor::Site& site, Alike alike) {
  std::vector<const floor::VehicleSetup*> kept;
  for (const floor::VehicleSetup& v : site.vehicles) {
    if (std::none_of(kept.begin(), kept.end(), [&](const floor::VehicleSetup* k) { return alike(*k, v); }))
      kept.push_back(&v);
  }
  return kept;
}

}  // namespace

std::vector<const floor::VehicleSetup*> bodiesOf(const floor::Site& site) {
  return withoutLikes(site, [](const floor::VehicleSetup& a, const floor::VehicleSetup& b) {
    return a.footprint == b.footprint && a.maxSpeed == b.maxSpeed && a.maxTurnRate == b.maxTurnRate;
  });
}

std::vector<const floor::VehicleSetup*> readerRowsOf(const floor::Site& site) {
  return withoutLikes(site, [](const floor::VehicleSetup& a, const floor::VehicleSetup& b) {
    return a.readers == b.readers && a.readerRadius == b.readerRadius;
  });
}

}  // namespace tessera::sitecheck
