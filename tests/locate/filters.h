// The two filters, made for the synthetic drive.
#pragma once

#include <memory>
#include <optional>

#include "locate/paper_floor.h"
#include "locate/particle_locator.h"

namespace tessera::test {

/// As the synthetic drive is: its readers tell at once, and its odometer wanders more than a vehicle's.
inline locate::ParticleOptions syntheticOptions() {
  locate::ParticleOptions options;
  options.readLag = 0.0;
  options.instant = 0.0;
  options.scaleMemory = 1.0;
  options.biasPerRootMetre = 0.02;
  return options;
}

inline std::unique_ptr<locate::ParticleLocator> particles(const std::shared_ptr<const floor::SiteMap>& map,
                                                          std::optional<Pose> start = std::nullopt) {
  floor::VehicleSetup vehicle = paperVehicle();
  vehicle.start = start;
  return std::make_unique<locate::ParticleLocator>(map, vehicle, syntheticOptions());
}

inline std::unique_ptr<locate::Locator> kalman(const std::shared_ptr<const floor::SiteMap>& map,
                                               std::optional<Pose> start = std::nullopt) {
  floor::VehicleSetup vehicle = paperVehicle();
  vehicle.start = start;
  return locate::makeLocator("kalman", map, vehicle).value();
}

}  // namespace tessera::test
