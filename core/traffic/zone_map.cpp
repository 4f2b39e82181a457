#include "traffic/zone_map.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"

namespace tessera::traffic {
namespace {

constexpr Metres kSliver{0.005};     // a shorter way in a zone is a line drawn along its edge, as the site check has it
constexpr Metres kAtTheTurn{0.02};   // before and behind a vertex, where it may stand while it turns
constexpr int kTurnCorners = 16;     // of the polygon around the circle of a turn on the spot
constexpr Radians kStraightOn{0.1};  // a bend of less is no turn

std::vector<Point> around(Point centre, Metres radius) {
  std::vector<Point> corners;
  const double outer = radius.value() / std::cos(kPi / kTurnCorners);
  for (int i = 0; i < kTurnCorners; ++i)
    corners.push_back(centre + turned({Metres{outer}, Metres{}}, Radians{2.0 * kPi * i / kTurnCorners}));
  return corners;
}

bool meets(const region::Region& area, const Box& bounds, const std::vector<Point>& outline) {
  return meet(bounds, boxAround(outline)) && !(area & region::Region::of(outline)).empty();
}

}  // namespace

ZoneMap::ZoneMap(std::span<const floor::Zone> zones) {
  for (const floor::Zone& zone : zones) {
    Area area{zone.name, region::Region::of(zone.outline), {}, {}, {}};
    if (area.region.empty()) continue;
    area.bounds = area.region.bounds();
    if (zone.kind == floor::ZoneKind::SingleVehicle) single_.push_back(area);
    if (zone.kind == floor::ZoneKind::Slow && zone.speed && *zone.speed > MetresPerSecond{}) {
      area.speed = *zone.speed;
      slow_.push_back(area);
    }
    if (zone.kind == floor::ZoneKind::OneWay && zone.direction) {
      area.direction = *zone.direction;
      oneWay_.push_back(area);
    }
  }
}

// On each leg the box meets what of the zone lies in the band that it sweeps: from where its front reaches the nearest
// point of that until its back has left the farthest one.
std::vector<drive::SpeedStretch> ZoneMap::stretches(const Area& area, const Polyline& way, const BodyBox& body) {
  std::vector<drive::SpeedStretch> found;
  for (std::size_t leg = 0; leg < way.legCount(); ++leg) {
    const Point from = way.vertices()[leg];
    const std::vector<Point> band = body.along(from, way.vertices()[leg + 1]);
    if (!meet(area.bounds, boxAround(band))) continue;
    const Metres start = way.startOf(leg);
    const Metres end = way.startOf(leg + 1);
    const Radians heading = way.headingOf(leg);
    for (const region::Region& piece : (area.region & region::Region::of(band)).pieces()) {
      Metres nearest{std::numeric_limits<double>::infinity()};
      Metres farthest = -1.0 * nearest;
      for (const region::Ring& ring : piece.rings()) {
        for (const region::Node& node : ring) {
          const Metres along = turned(region::pointOf(node) - from, -1.0 * heading).x;
          nearest = std::min(nearest, along);
          farthest = std::max(farthest, along);
        }
      }
      const Metres enters = std::max(start + nearest - body.front, start);
      const Metres leaves = std::min(start + farthest + body.back, end);
      if (enters < leaves) found.push_back({enters, leaves, area.speed});
    }
  }
  return found;
}

void ZoneMap::addTurns(const Area& area, const Polyline& way, Metres reach, std::vector<drive::SpeedStretch>& into) {
  for (std::size_t vertex = 0; vertex < way.legCount(); ++vertex) {
    // However it stands at the start, it turns to the first leg.
    const bool turns = vertex == 0 || abs(turnBetween(way.headingOf(vertex - 1), way.headingOf(vertex))) > kStraightOn;
    if (!turns || !meets(area.region, area.bounds, around(way.vertices()[vertex], reach))) continue;
    const Metres at = way.startOf(vertex);
    into.push_back({std::max(at - kAtTheTurn, Metres{}), std::min(at + kAtTheTurn, way.length()), area.speed});
  }
}

drive::StretchLimits ZoneMap::slowStretches(const Polyline& way, const BodyBox& body) const {
  std::vector<drive::SpeedStretch> all;
  for (const Area& area : slow_) {
    const auto of = stretches(area, way, body.grown(kClearance));
    all.insert(all.end(), of.begin(), of.end());
  }
  return {drive::StretchLimits::Of::Zones, std::move(all)};
}

std::vector<Crossing> ZoneMap::crossings(const Polyline& way, const BodyBox& body) const {
  std::vector<Crossing> all;
  for (std::size_t zone = 0; zone < single_.size(); ++zone) {
    auto found = stretches(single_[zone], way, body.grown(kClearance));
    addTurns(single_[zone], way, body.grown(kClearance).reach(), found);
    for (const drive::SpeedStretch& stretch : found) all.push_back({stretch.from, stretch.to, zone});
  }
  std::sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) { return a.from < b.from; });
  return all;
}

std::vector<std::size_t> ZoneMap::zonesUnder(const Pose& pose, const BodyBox& body) const {
  std::vector<std::size_t> found;
  if (single_.empty()) return found;
  const std::vector<Point> outline = body.at(pose);
  for (std::size_t zone = 0; zone < single_.size(); ++zone)
    if (meets(single_[zone].region, single_[zone].bounds, outline)) found.push_back(zone);
  return found;
}

std::optional<WrongWay> ZoneMap::wrongWay(const Polyline& line) const {
  for (const Area& area : oneWay_) {
    Metres length;
    for (std::size_t leg = 0; leg < line.legCount(); ++leg) {
      if (abs(turnBetween(area.direction, line.headingOf(leg))) <= Radians{kPi / 2 + 1e-6}) continue;
      const Metres whole = line.startOf(leg + 1) - line.startOf(leg);
      for (const region::Stretch& s : area.region.within(line.vertices()[leg], line.vertices()[leg + 1]))
        length += (s.to - s.from) * whole;
    }
    if (length > kSliver) return WrongWay{area.name, length};
  }
  return std::nullopt;
}

}  // namespace tessera::traffic
