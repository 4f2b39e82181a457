// The highest speeds of edges: how a site's vehicles, slow zones and legs make them, and which leg's speed one stands
// for. For this folder's sources.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "floor/site.h"
#include "region/region.h"

namespace tessera::exchange {

/// One for each set of abilities, called after the first vehicle that has them.
struct VehicleType {
  std::string id;
  const floor::VehicleSetup* vehicle;
};
/// At least one; they point into the site.
[[nodiscard]] std::vector<VehicleType> vehicleTypes(const floor::Site& site);

class EdgeSpeeds {
public:
  explicit EdgeSpeeds(const floor::Site& site);
  /// As fast as vehicle, leg and the slowest zone on the way allow.
  [[nodiscard]] MetresPerSecond of(MetresPerSecond vehicle, Point a, Point b, std::optional<MetresPerSecond> leg) const;

private:
  std::vector<std::pair<region::Region, MetresPerSecond>> slow_;
};

/// What a file says of one edge, by the type of vehicle.
using TypeSpeeds = std::vector<std::pair<std::string, MetresPerSecond>>;

/// Speeds of legs out of those of edges. An edge that is as fast as vehicles and slow zones are there anyway says
/// nothing of its leg.
class LegSpeedFinder {
public:
  LegSpeedFinder(const floor::Site& onto, const std::vector<TypeSpeeds>& edges);
  /// known: of that leg in the site so far; it stays where the file says the same.
  [[nodiscard]] std::optional<MetresPerSecond> find(const TypeSpeeds& edge, Point a, Point b,
                                                    std::optional<MetresPerSecond> known) const;

private:
  [[nodiscard]] MetresPerSecond fastest(const std::string& type) const;

  EdgeSpeeds speeds_;
  std::map<std::string, MetresPerSecond> own_;     ///< of the site's types
  std::map<std::string, MetresPerSecond> ofFile_;  ///< the highest anywhere in the file
  std::optional<MetresPerSecond> fastestVehicle_;  ///< of the site's
};

}  // namespace tessera::exchange
