#include "locate/locator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "locate/kalman_locator.h"
#include "locate/particle_locator.h"
#include "locate/tag_centre_locator.h"

namespace tessera::locate {
namespace {

constexpr std::array<std::string_view, 3> kNames{ParticleLocator::kName, KalmanLocator::kName, TagCentreLocator::kName};

}  // namespace

Metres Estimate::positionSigma() const {
  const double mean = 0.5 * (covariance(0, 0) + covariance(1, 1));
  const double spread = std::hypot(0.5 * (covariance(0, 0) - covariance(1, 1)), covariance(0, 1));
  return Metres{std::sqrt(std::max(0.0, mean + spread))};
}

std::span<const std::string_view> locatorNames() { return kNames; }

Result<std::unique_ptr<Locator>> makeLocator(std::string_view name, std::shared_ptr<const floor::SiteMap> map,
                                             const floor::VehicleSetup& vehicle) {
  if (!map) return failure("A locator needs a site's map.");
  const std::string who = "Vehicle \"" + vehicle.name + "\"";
  if (vehicle.readers.empty()) return failure(who + " has no tag readers, so it cannot be located.");
  if (vehicle.readers.size() > KalmanLocator::kMaxReaders)
    return failure(who + " has more than " + std::to_string(KalmanLocator::kMaxReaders) + " tag readers.");
  if (!(vehicle.readerRadius > Metres{0.0} && vehicle.readerRadius < Metres{1.0}))
    return failure(who + " has a reader radius that is not between 0 and 1 m.");
  if (name == KalmanLocator::kName) return std::make_unique<KalmanLocator>(std::move(map), vehicle);
  if (name == ParticleLocator::kName) return std::make_unique<ParticleLocator>(std::move(map), vehicle);
  if (name == TagCentreLocator::kName) return std::make_unique<TagCentreLocator>(std::move(map), vehicle);
  std::string known;
  for (std::string_view n : kNames) known += (known.empty() ? "" : ", ") + std::string{n};
  return failure("There is no locator \"" + std::string{name} + "\"; there are: " + known + ".");
}

}  // namespace tessera::locate
