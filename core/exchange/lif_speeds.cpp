#include "exchange/lif_speeds.h"

#include <algorithm>
#include <limits>

#include "floor/route_legs.h"

namespace tessera::exchange {
namespace {

using floor::VehicleSetup;

const std::string kOurs = "Tessera.";

}  // namespace

std::vector<VehicleType> vehicleTypes(const floor::Site& site) {
  std::vector<VehicleType> types;
  for (const VehicleSetup& v : site.vehicles) {
    const auto alike = [&v](const VehicleType& t) {
      return t.vehicle->footprint == v.footprint && t.vehicle->maxSpeed == v.maxSpeed &&
             t.vehicle->maxTurnRate == v.maxTurnRate;
    };
    if (std::none_of(types.begin(), types.end(), alike)) types.push_back({kOurs + v.name, &v});
  }
  static const VehicleSetup usual;
  if (types.empty()) types.push_back({kOurs + "AGV", &usual});
  return types;
}

EdgeSpeeds::EdgeSpeeds(const floor::Site& site) {
  for (const floor::Zone& zone : site.zones)
    if (zone.kind == floor::ZoneKind::Slow && zone.speed)
      slow_.emplace_back(region::Region::of(zone.outline), *zone.speed);
}

MetresPerSecond EdgeSpeeds::of(MetresPerSecond vehicle, Point a, Point b, std::optional<MetresPerSecond> leg) const {
  MetresPerSecond speed = std::min(vehicle, leg.value_or(vehicle));
  for (const auto& [area, limit] : slow_)
    if (limit < speed && !area.within(a, b).empty()) speed = limit;
  return speed;
}

LegSpeedFinder::LegSpeedFinder(const floor::Site& onto, const std::vector<TypeSpeeds>& edges) : speeds_{onto} {
  for (const VehicleType& type : vehicleTypes(onto)) own_.emplace(type.id, type.vehicle->maxSpeed);
  for (const VehicleSetup& v : onto.vehicles)
    fastestVehicle_ = std::max(fastestVehicle_.value_or(v.maxSpeed), v.maxSpeed);
  for (const TypeSpeeds& edge : edges)
    for (const auto& [type, speed] : edge) {
      auto& most = ofFile_[type];
      most = std::max(most, speed);
    }
}

MetresPerSecond LegSpeedFinder::fastest(const std::string& type) const {
  if (const auto known = own_.find(type); known != own_.end()) return known->second;
  // Of our own export, whose vehicle this site has not: its legs without a speed have the vehicle's.
  if (type.rfind(kOurs, 0) == 0) return ofFile_.at(type);
  return fastestVehicle_.value_or(MetresPerSecond{std::numeric_limits<double>::infinity()});
}

std::optional<MetresPerSecond> LegSpeedFinder::find(const TypeSpeeds& edge, Point a, Point b,
                                                    std::optional<MetresPerSecond> known) const {
  std::optional<MetresPerSecond> found;
  bool asKnown = true;
  for (const auto& [type, speed] : edge) {
    const MetresPerSecond vehicle = fastest(type);
    asKnown = asKnown && speed == speeds_.of(vehicle, a, b, known);
    if (speed < speeds_.of(vehicle, a, b, {})) found = std::min(found.value_or(speed), speed);
  }
  if (asKnown) return known;
  if (!found || *found > floor::kMostLegSpeed) return std::nullopt;
  return std::max(*found, floor::kLeastLegSpeed);
}

}  // namespace tessera::exchange
