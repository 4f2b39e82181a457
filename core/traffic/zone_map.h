// The zones that bind who drives, as areas, and where ways and vehicles meet them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/polyline.h"
#include "drive/stretch_limits.h"
#include "region/region.h"
#include "traffic/body_box.h"

namespace tessera::traffic {

/// Free room kept between a vehicle's box and a zone's edge: what it may stray from its line and err in its place.
inline constexpr Metres kClearance{0.05};

/// A stretch of a way on which the vehicle is, with its body, in a single-vehicle zone.
struct Crossing {
  Metres from;
  Metres to;
  std::size_t zone;  ///< index of ZoneMap::single()
};

struct WrongWay {
  std::string zone;
  Metres length;
};

class ZoneMap {
public:
  ZoneMap() = default;
  explicit ZoneMap(std::span<const floor::Zone> zones);

  /// Where a vehicle must keep to the speeds of slow zones: as long as any part of its box, grown by the clearance, is
  /// in one.
  [[nodiscard]] drive::StretchLimits slowStretches(const Polyline& way, const BodyBox& body) const;
  /// In their order; each as long as any part of the box, grown by the clearance, is in the zone, turns on the spot
  /// included.
  [[nodiscard]] std::vector<Crossing> crossings(const Polyline& way, const BodyBox& body) const;
  /// The single-vehicle zones in which a part of a box is that stands there, in ascending order.
  [[nodiscard]] std::vector<std::size_t> zonesUnder(const Pose& pose, const BodyBox& body) const;
  /// The first one-way zone through which the line leads by more than 90° from the zone's direction.
  [[nodiscard]] std::optional<WrongWay> wrongWay(const Polyline& line) const;
  [[nodiscard]] std::size_t singleCount() const { return single_.size(); }
  [[nodiscard]] const std::string& singleName(std::size_t zone) const { return single_.at(zone).name; }

private:
  struct Area {
    std::string name;
    region::Region region;
    Box bounds;
    MetresPerSecond speed;
    Radians direction;
  };
  static std::vector<drive::SpeedStretch> stretches(const Area& area, const Polyline& way, const BodyBox& body);
  static void addTurns(const Area& area, const Polyline& way, Metres reach, std::vector<drive::SpeedStretch>& into);

  std::vector<Area> slow_;
  std::vector<Area> oneWay_;
  std::vector<Area> single_;
};

}  // namespace tessera::traffic
