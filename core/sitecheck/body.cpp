#include "sitecheck/body.h"

#include <algorithm>

#include "floor/new_floor.h"

namespace tessera::sitecheck {
namespace {

const floor::VehicleSetup& usual() {
  static const floor::VehicleSetup vehicle = floor::usualVehicle();
  return vehicle;
}

template <class Alike>
std::vector<const floor::VehicleSetup*> withoutLikes(const floor::Site& site, Alike alike) {
  if (site.vehicles.empty()) return {&usual()};
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
    return a.footprint == b.footprint && a.maxSpeed == b.maxSpeed && a.maxTurnRate == b.maxTurnRate &&
           a.cornerCut == b.cornerCut;
  });
}

std::vector<const floor::VehicleSetup*> readerRowsOf(const floor::Site& site) {
  return withoutLikes(site, [](const floor::VehicleSetup& a, const floor::VehicleSetup& b) {
    return a.readers == b.readers && a.readerRadius == b.readerRadius;
  });
}

bool isUsual(const floor::VehicleSetup& vehicle) { return &vehicle == &usual(); }

Sentence nameOf(const floor::VehicleSetup& vehicle) {
  if (isUsual(vehicle)) return phrase("Core", "a usual vehicle");
  return phrase("Core", "vehicle \"%1\"").with(vehicle.name);
}

void addTo(std::vector<Object>& objects, const floor::VehicleSetup& vehicle) {
  if (!isUsual(vehicle)) objects.push_back({ObjectKind::Vehicle, vehicle.name});
}

bool isOf(const Fault& fault, const floor::VehicleSetup& vehicle) {
  if (fault.objects.size() < 2) return isUsual(vehicle);
  return !isUsual(vehicle) && fault.objects[1].name == vehicle.name;
}

}  // namespace tessera::sitecheck
