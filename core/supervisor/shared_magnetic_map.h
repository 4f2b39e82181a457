// The magnetic map of the site's floor, one for all its vehicles: read while they are told of reports, taught at the
// end of the tick, and handed out as pictures.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "locate/magnetic_map.h"
#include "supervisor/vehicle_agent.h"

namespace tessera::supervisor {

class SharedMagneticMap {
public:
  /// Goes on with this one; null: with an empty one. byIt: vehicles are located by it.
  void use(const std::shared_ptr<const locate::MagneticMap>& map, std::vector<VehicleAgent>& agents, bool byIt);
  /// To be called once a tick, when nobody reads the map.
  void learn(std::vector<VehicleAgent>& agents, Seconds now);
  /// A second old at most, and the same while nothing was learned.
  [[nodiscard]] const std::shared_ptr<const locate::MagneticMap>& picture() const { return picture_; }

private:
  std::shared_ptr<locate::MagneticMap> map_;
  std::shared_ptr<const locate::MagneticMap> picture_;
  bool changed_ = false;  ///< since the picture
  Seconds nextPicture_{-std::numeric_limits<double>::infinity()};
};

}  // namespace tessera::supervisor
