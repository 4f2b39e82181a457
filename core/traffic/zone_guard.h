// Leads one vehicle's drive by the zones: their speeds, and where it waits for others before single-vehicle zones.
// Zones between which it could not wait without standing in one of them are asked for together.
#pragma once

#include <memory>

#include "drive/way_guard.h"
#include "traffic/right_of_way.h"
#include "traffic/zone_map.h"

namespace tessera::traffic {

/// What the vehicles of a site share.
struct Traffic {
  ZoneMap zones;
  RightOfWay rights;
};

class ZoneGuard final : public drive::WayGuard {
public:
  ZoneGuard(VehicleId vehicle, const BodyBox& body, std::shared_ptr<Traffic> traffic);

  void laid(const Polyline& way) override;
  [[nodiscard]] const drive::StretchLimits& limits() const override { return limits_; }
  [[nodiscard]] Metres mayGoTo(Metres along, Metres ahead) override;
  /// The zones that it has been let into and has not left behind.
  [[nodiscard]] RightOfWay::Zones needed() const;
  /// The site's zones are others now.
  void zonesChanged() { laid(Polyline{way_}); }

private:
  struct Block {
    std::vector<Crossing> crossings;
    Metres from;
    Metres to;
  };
  [[nodiscard]] RightOfWay::Zones ahead(const Block& block) const;

  VehicleId vehicle_;
  BodyBox body_;
  std::shared_ptr<Traffic> traffic_;
  Polyline way_;
  drive::StretchLimits limits_;
  std::vector<Block> blocks_;  ///< in the order of the way
  std::size_t next_ = 0;       ///< first block that is not left behind
  std::size_t allowed_ = 0;    ///< one more than the last block that it was let into
  Metres along_;
};

}  // namespace tessera::traffic
