#include "supervisor/shared_magnetic_map.h"

namespace tessera::supervisor {
namespace {

constexpr Seconds kBetweenPictures{1.0};

}  // namespace

void SharedMagneticMap::use(const std::shared_ptr<const locate::MagneticMap>& map, std::vector<VehicleAgent>& agents,
                            bool byIt) {
  map_ = map ? std::make_shared<locate::MagneticMap>(*map) : std::make_shared<locate::MagneticMap>();
  // The very one that was given, so that whoever gave it knows when it is in use.
  picture_ = map ? map : std::make_shared<const locate::MagneticMap>();
  changed_ = false;
  for (VehicleAgent& agent : agents) agent.useMagneticMap(map_, byIt);
}

void SharedMagneticMap::learn(std::vector<VehicleAgent>& agents, Seconds now) {
  for (VehicleAgent& agent : agents) changed_ = agent.teach(*map_) || changed_;
  if (!changed_ || now < nextPicture_) return;
  picture_ = std::make_shared<const locate::MagneticMap>(*map_);
  changed_ = false;
  nextPicture_ = now + kBetweenPictures;
}

}  // namespace tessera::supervisor
