#include "sitediff/figures.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/rounded_line.h"
#include "floor/laid_tile.h"
#include "floor/route_legs.h"
#include "floor/tile_finder.h"
#include "region/region.h"

namespace tessera::sitediff {
namespace {

using floor::Site;
using floor::VehicleSetup;
using region::Region;

constexpr double kSharpCorner = 0.35;  // rad, as the speed plan has it
constexpr double kBrakingShare = 0.5;  // likewise
constexpr double kTurnOnArcs = 0.77;   // rad/s, at which a vehicle that holds headings is led round an arc

struct SlowArea {
  Region area;
  double speed;
};

// From standing to standing: up, along, down; short ways never reach the speed.
double timeBetweenStops(double way, double speed, double acceleration) {
  const double up = acceleration;
  const double down = kBrakingShare * acceleration;
  const double ramps = speed * speed / 2 * (1 / up + 1 / down);
  if (way >= ramps) return way / speed + speed / 2 * (1 / up + 1 / down);
  const double peak = std::sqrt(2 * way / (1 / up + 1 / down));
  return peak / up + peak / down;
}

// Seconds lost on a leg by its own highest speed and in slow zones; the lowest speed holds.
double lostOnLeg(Point a, Point b, double speed, double legSpeed, const std::vector<SlowArea>& slow) {
  std::vector<double> cuts{0.0, 1.0};
  for (const SlowArea& s : slow)
    for (const region::Stretch& part : s.area.within(a, b)) cuts.insert(cuts.end(), {part.from, part.to});
  std::sort(cuts.begin(), cuts.end());
  double lost = 0.0;
  const double way = distance(a, b).value();
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Point middle = a + 0.5 * (cuts[i] + cuts[i + 1]) * (b - a);
    double limit = std::min(speed, legSpeed);
    for (const SlowArea& s : slow)
      if (s.speed < limit && s.area.contains(middle)) limit = s.speed;
    lost += (cuts[i + 1] - cuts[i]) * way * (1 / limit - 1 / speed);
  }
  return lost;
}

RouteFigures routeFigures(const floor::Route& route, const VehicleSetup& v, double speed,
                          const std::vector<SlowArea>& slow) {
  const Polyline line{route.vertices};
  const auto legSpeeds = floor::legSpeedsOfLine(route);
  const RoundedLine way{line, v.cornerCut, Radians{kSharpCorner}};
  const auto arcAt = [&way](Metres vertex) {
    return std::find_if(way.arcs().begin(), way.arcs().end(), [&](const auto& arc) { return arc.vertex == vertex; });
  };
  RouteFigures figures{route.name, line.length(), 0, {}};
  double seconds = 0.0;
  double stoppedAt = 0.0;
  for (std::size_t leg = 0; leg < line.legCount(); ++leg) {
    const double legSpeed = legSpeeds[leg].value_or(MetresPerSecond{speed}).value();
    seconds += lostOnLeg(line.vertices()[leg], line.vertices()[leg + 1], speed, legSpeed, slow);
    const bool last = leg + 1 == line.legCount();
    const double turn = last ? 0.0 : std::abs(turnBetween(line.headingOf(leg), line.headingOf(leg + 1)).value());
    if (!last && turn < kSharpCorner) continue;
    if (const auto arc = arcAt(line.startOf(leg + 1)); !last && arc != way.arcs().end()) {
      const double pace = std::min(speed, std::min(v.maxTurnRate.value(), kTurnOnArcs) * arc->radius.value());
      const double slower = speed - pace;
      const double ramps = slower * slower / (2 * speed * v.acceleration.value()) * (1 + 1 / kBrakingShare);
      // The way along the legs was counted already.
      seconds += (arc->to - arc->from).value() / pace - 2 * arc->tangent.value() / speed + ramps;
      continue;
    }
    ++figures.stops;
    const double here = line.startOf(leg + 1).value();
    seconds += timeBetweenStops(here - stoppedAt, speed, v.acceleration.value()) + turn / v.maxTurnRate.value();
    stoppedAt = here;
  }
  figures.time = Seconds{seconds};
  return figures;
}

void tiles(const Site& site, Figures& figures) {
  std::unordered_map<const floor::TileType*, std::size_t> tags;
  for (const floor::TileType& t : site.tileTypes) tags[&t] = tagOffsets(t).size();
  floor::LaidTypes types{site};
  floor::TileFinder known{site.tiles};
  std::vector<Box> boxes;
  for (std::size_t n = 0; n < site.placements.size(); ++n) {
    const floor::Placement& p = site.placements[n];
    const floor::TileType* type = types.find(p, n);
    if (type == nullptr) continue;
    ++figures.tilesLaid;
    figures.tagPlaces += tags[type];
    const auto& uids = known.find(p.serial, n)->uids;
    figures.registered += static_cast<std::size_t>(
        std::count_if(uids.begin(), uids.end(), [](const floor::TagUid& u) { return !u.empty(); }));
    boxes.push_back(boxOf(p, *type));
  }
  figures.tilesKnown = site.tiles.size();
  figures.floorSquareMetres = Region::unionOf(boxes).squareMetres();
}

}  // namespace

Figures figuresOf(const Site& site, std::optional<MetresPerSecond> speed) {
  Figures figures;
  tiles(site, figures);
  figures.looseTags = site.looseTags.size();
  figures.vehicles = site.vehicles.size();
  std::vector<SlowArea> slow;
  for (const floor::Zone& zone : site.zones) {
    const Region area = Region::of(zone.outline);
    figures.zones.push_back({zone.name, zone.kind, area.squareMetres()});
    if (zone.kind == floor::ZoneKind::Slow && zone.speed && zone.speed->value() > 0.0)
      slow.push_back({area, zone.speed->value()});
  }
  const VehicleSetup vehicle = site.vehicles.empty() ? VehicleSetup{} : site.vehicles.front();
  const double v = std::min(speed.value_or(vehicle.maxSpeed), vehicle.maxSpeed).value();
  for (const floor::Route& route : site.routes) figures.routes.push_back(routeFigures(route, vehicle, v, slow));
  return figures;
}

}  // namespace tessera::sitediff
