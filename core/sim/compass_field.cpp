#include "sim/compass_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "floor/bearing.h"
#include "sim/site_bounds.h"

namespace tessera::sim {
namespace {

// Down into the floor on the northern half of the globe; the hard iron along z keeps the sum positive.
constexpr double kEarthVertical = -40.0;
constexpr double kHardIronZ = 90.0;
constexpr double kFloorPerSpot = 1.5;  // m²

}  // namespace

std::vector<MagneticSpot> seededSpots(const floor::Site& site, Radians deviation, std::uint64_t seed) {
  std::vector<MagneticSpot> spots;
  const auto bounds = boundsOf(site);
  if (!bounds || deviation.value() == 0.0) return spots;
  RandomStream random{seed, "magnetic spots"};
  const Offset size = bounds->upperRight - bounds->lowerLeft;
  const int count = std::max(1, static_cast<int>(std::lround(size.x.value() * size.y.value() / kFloorPerSpot)));
  const double peak = kEarthHorizontal * std::tan(deviation.value());
  for (int i = 0; i < count; ++i) {
    const Offset from{size.x * random.uniform(), size.y * random.uniform()};
    const double angle = random.between(-kPi, kPi);
    const Metres radius{random.between(0.2, 0.4)};
    spots.push_back({bounds->lowerLeft + from, radius, {peak * std::cos(angle), peak * std::sin(angle)}});
  }
  return spots;
}

CompassField::CompassField(const CompassParameters& parameters, Radians northToY, std::vector<MagneticSpot> spots,
                           RandomStream random)
    : parameters_{parameters}, northToY_{northToY}, spots_{std::move(spots)}, random_{random} {
  mounting_ = random_.chance(0.5) ? parameters_.bias : -parameters_.bias;
  for (double& axis : hardIron_) axis = parameters_.hardIron + random_.normal(parameters_.hardIronSpread);
  const double spread = parameters_.softIron;
  softIron_ = {1.0 + random_.normal(spread), random_.normal(spread) / 2.0, 1.0 + random_.normal(spread)};
}

std::array<double, 2> CompassField::atPlace(Point place) const {
  const Radians north = floor::headingOfBearing(Radians{0.0}, northToY_);
  std::array<double, 2> field{kEarthHorizontal * cos(north), kEarthHorizontal * sin(north)};
  for (const MagneticSpot& spot : spots_) {
    const double reach = distance(place, spot.centre) / spot.radius;
    if (reach > 5.0) continue;
    const double share = std::exp(-reach * reach / 2.0);
    field[0] += share * spot.peak[0];
    field[1] += share * spot.peak[1];
  }
  return field;
}

std::array<double, 3> CompassField::measure(const Pose& vehicle) {
  const std::array<double, 2> site = atPlace(vehicle.position);
  const Radians chip = vehicle.heading + mounting_;
  const double forward = site[0] * cos(chip) + site[1] * sin(chip);
  const double left = -site[0] * sin(chip) + site[1] * cos(chip);
  const auto noise = [this] { return random_.normal(parameters_.noise); };
  return {softIron_[0] * forward + softIron_[1] * left + hardIron_[0] + noise(),
          softIron_[1] * forward + softIron_[2] * left + hardIron_[1] + noise(), kEarthVertical + kHardIronZ + noise()};
}

}  // namespace tessera::sim
