#include "sitecheck/route_zones.h"

#include <algorithm>

#include "floor/route_legs.h"
#include "sitecheck/body.h"
#include "sitecheck/round_ways.h"
#include "sitecheck/wording.h"

namespace tessera::sitecheck {
namespace {

using floor::Route;
using floor::VehicleSetup;
using floor::Zone;
using floor::ZoneKind;
using region::Region;
using region::Stretch;

constexpr Metres kSliver{0.005};  // shorter ways outside are a line drawn along an edge

// Length of a way's parts, and the box around them.
struct Parts {
  Metres length;
  std::optional<Box> place;
  void add(Point from, Point to, const Stretch& s) {
    const Point ends[] = {from + s.from * (to - from), from + s.to * (to - from)};
    length += distance(ends[0], ends[1]);
    reach(boxAround(ends));
  }
  void reach(const Box& box) { place = place ? boxAround(*place, box) : box; }
};

template <class Visit>
void forEachLeg(const Polyline& line, Visit visit) {
  for (std::size_t leg = 0; leg < line.legCount(); ++leg) visit(leg, line.vertices()[leg], line.vertices()[leg + 1]);
}

Parts inside(const Polyline& line, const Region& area) {
  Parts parts;
  forEachLeg(line, [&](std::size_t, Point a, Point b) {
    for (const Stretch& s : area.within(a, b)) parts.add(a, b, s);
  });
  return parts;
}

Parts outside(const Polyline& line, const Region& area) {
  Parts parts;
  forEachLeg(line, [&](std::size_t, Point a, Point b) {
    double at = 0.0;
    for (const Stretch& s : area.within(a, b)) {
      if (s.from > at) parts.add(a, b, {at, s.from});
      at = s.to;
    }
    if (at < 1.0) parts.add(a, b, {at, 1.0});
  });
  return parts;
}

// Nothing of the area lies in the box.
bool isApart(const Region& area, const Box& box) { return area.empty() || !meet(area.bounds(), box); }

// All of the box lies in the area, and its edge nowhere near: quicker to see than where an arc's many legs lie.
bool isCovered(const Region& area, const Box& box) {
  for (const region::Ring& ring : area.rings()) {
    Point last = pointOf(ring.back());
    for (const region::Node& node : ring) {
      const Point next = pointOf(node);
      if (meet(boxAround(Box{last, last}, Box{next, next}), box)) return false;
      last = next;
    }
  }
  return area.contains(box.low);
}

Parts against(const Polyline& line, const Region& area, Radians direction) {
  Parts parts;
  forEachLeg(line, [&](std::size_t leg, Point a, Point b) {
    if (abs(turnBetween(direction, line.headingOf(leg))) <= Radians{kPi / 2 + 1e-6}) return;
    for (const Stretch& s : area.within(a, b)) parts.add(a, b, s);
  });
  return parts;
}

class Judge {
public:
  Judge(const Context& context, const Route& route, const Polyline& line)
      : context_{context}, route_{route}, line_{line}, ways_{roundWaysOf(context, line)} {}

  ZoneVerdict judge() {
    for (std::size_t i = 0; i < zones().size(); ++i)
      if (zones()[i].kind == ZoneKind::NoGo) noGo(zones()[i], context_.zones.areas[i].grown(-1.0 * kSliver));
    if (context_.zones.anyRunning && verdict_.lineOnFloor) running();
    for (std::size_t i = 0; i < zones().size(); ++i)
      if (zones()[i].kind == ZoneKind::OneWay && zones()[i].direction) oneWay(zones()[i], context_.zones.areas[i]);
    for (std::size_t i = 0; i < zones().size() && !route_.legSpeeds.empty(); ++i)
      if (zones()[i].kind == ZoneKind::Slow && zones()[i].speed) slow(zones()[i], context_.zones.areas[i]);
    return std::move(verdict_);
  }

private:
  [[nodiscard]] const std::vector<Zone>& zones() const { return context_.site.zones; }

  Fault& tell(FaultKind kind, Severity severity, const Sentence& sentence, const Parts& parts) {
    verdict_.faults.push_back({kind, severity, sentence, {}, {{ObjectKind::Route, route_.name}}, {}});
    if (parts.place && isPlace(*parts.place)) verdict_.faults.back().place = parts.place;
    return verdict_.faults.back();
  }

  // Visits the ways that break a zone, with how much of them does, and the number of the first vertex where they do.
  // Between its corners a way is the line drawn: only where a corner has part in it is all of it measured.
  // `sees`: whether a corner's box need be looked into.
  template <class Sees, class Measure, class Visit>
  void forEachRound(Sees sees, Measure measure, Visit visit) {
    for (const RoundWay& way : ways_) {
      Parts at;
      std::optional<std::size_t> first;
      for (const RoundCorner& corner : way.corners) {
        if (!sees(corner.box)) continue;
        for (const Polyline* half : {&corner.before, &corner.behind}) {
          const Parts parts = measure(*half);
          if (!(parts.length > Metres{})) continue;
          const Point vertex = line_.vertices()[corner.vertex];
          at.reach(boxAround(*parts.place, Box{vertex, vertex}));
          if (!first) first = corner.vertex;
        }
      }
      if (!first) continue;
      at.length = measure(way.whole).length;
      if (at.length > kSliver) visit(*way.vehicle, at, numberOf(*first) + 1);
    }
  }

  void noGo(const Zone& zone, const Region& area) {
    const auto measure = [&](const Polyline& way) { return inside(way, area); };
    const auto comesNear = [&](const Box& box) { return !isApart(area, box); };
    if (const Parts parts = measure(line_); parts.length > kSliver) {
      verdict_.lineOnFloor = false;
      tell(FaultKind::RouteCrossesNoGo, Severity::Error,
           phrase("Core", "Route \"%1\" leads %2 m through the no-go zone \"%3\".")
               .with(route_.name, inMetres(parts.length), zone.name),
           parts)
          .objects.push_back({ObjectKind::Zone, zone.name});
      return;
    }
    forEachRound(comesNear, measure, [&](const VehicleSetup& v, const Parts& parts, std::size_t vertex) {
      verdict_.cutsOffIt.push_back(v.cornerCut);
      Fault& fault = tell(FaultKind::RouteCrossesNoGo, Severity::Error,
                          phrase("Core",
                                 "Rounding the corners of route \"%1\", %2 drives %3 m through the no-go zone \"%4\", "
                                 "first at vertex %5.")
                              .with(route_.name, nameOf(v), inMetres(parts.length), zone.name, vertex),
                          parts);
      fault.objects.push_back({ObjectKind::Zone, zone.name});
      addTo(fault.objects, v);
    });
  }

  void running() {
    const auto measure = [&](const Polyline& way) { return outside(way, context_.zones.drivable); };
    const auto comesOut = [&](const Box& box) { return !isCovered(context_.zones.drivable, box); };
    if (const Parts parts = measure(line_); parts.length > kSliver) {
      verdict_.lineOnFloor = false;
      tell(FaultKind::RouteLeavesRunningZone, Severity::Error,
           phrase("Core", "Route \"%1\" leads %2 m outside the zones in which vehicles may be.")
               .with(route_.name, inMetres(parts.length)),
           parts);
      return;
    }
    forEachRound(comesOut, measure, [&](const VehicleSetup& v, const Parts& parts, std::size_t vertex) {
      if (!verdict_.isOnFloor(v)) return;
      verdict_.cutsOffIt.push_back(v.cornerCut);
      addTo(tell(FaultKind::RouteLeavesRunningZone, Severity::Error,
                 phrase("Core",
                        "Rounding the corners of route \"%1\", %2 drives %3 m outside the zones in which vehicles may "
                        "be, first at vertex %4.")
                     .with(route_.name, nameOf(v), inMetres(parts.length), vertex),
                 parts)
                .objects,
            v);
    });
  }

  void oneWay(const Zone& zone, const Region& area) {
    const auto measure = [&](const Polyline& way) { return against(way, area, *zone.direction); };
    const auto comesNear = [&](const Box& box) { return !isApart(area, box); };
    if (const Parts parts = measure(line_); parts.length > kSliver) {
      tell(FaultKind::RouteAgainstOneWay, Severity::Error,
           phrase("Core", "Route \"%1\" leads %2 m the wrong way through the one-way zone \"%3\".")
               .with(route_.name, inMetres(parts.length), zone.name),
           parts)
          .objects.push_back({ObjectKind::Zone, zone.name});
      return;
    }
    forEachRound(comesNear, measure, [&](const VehicleSetup& v, const Parts& parts, std::size_t vertex) {
      Fault& fault =
          tell(FaultKind::RouteAgainstOneWay, Severity::Error,
               phrase("Core",
                      "Rounding the corners of route \"%1\", %2 drives %3 m the wrong way through the one-way zone "
                      "\"%4\", first at vertex %5.")
                   .with(route_.name, nameOf(v), inMetres(parts.length), zone.name, vertex),
               parts);
      fault.objects.push_back({ObjectKind::Zone, zone.name});
      addTo(fault.objects, v);
    });
  }

  void slow(const Zone& zone, const Region& area) {
    for (std::size_t leg = 0; leg < floor::legCount(route_); ++leg) {
      const auto speed = floor::legSpeed(route_, leg);
      if (!speed || *speed <= *zone.speed) continue;
      const Polyline line{{route_.vertices[leg], route_.vertices[leg + 1]}};
      if (const Parts parts = inside(line, area); parts.length > kSliver) {
        const Sentence sentence =
            phrase("Core",
                   "Leg %1 of route \"%2\" may be driven at %3 m/s, but leads through the slow zone \"%4\" of %5 m/s.")
                .with(leg + 1, route_.name, figure(speed->value(), 2), zone.name, figure(zone.speed->value(), 2));
        tooFast(zone, leg, *speed, sentence, parts);
      } else {
        slowRound(zone, area, leg, *speed);
      }
    }
  }

  // Of a corner the leg before it has the half as far as the middle, the next one the other.
  void slowRound(const Zone& zone, const Region& area, std::size_t leg, MetresPerSecond speed) {
    for (const RoundWay& way : ways_) {
      Parts all;
      for (const RoundCorner& corner : way.corners) {
        if (isApart(area, corner.box)) continue;
        for (const bool before : {true, false}) {
          if (numberOf(corner.vertex + (before ? 0 : 1)) != leg + 1) continue;
          const Parts parts = inside(before ? corner.before : corner.behind, area);
          all.length += parts.length;
          if (parts.place) all.reach(*parts.place);
        }
      }
      if (all.length <= kSliver) continue;
      const Sentence sentence =
          phrase("Core",
                 "Leg %1 of route \"%2\" may be driven at %3 m/s, but rounding its corner %6 comes through the slow "
                 "zone \"%4\" of %5 m/s.")
              .with(leg + 1, route_.name, figure(speed.value(), 2), zone.name, figure(zone.speed->value(), 2),
                    nameOf(*way.vehicle));
      addTo(tooFast(zone, leg, speed, sentence, all).objects, *way.vehicle);
      return;
    }
  }

  Fault& tooFast(const Zone& zone, std::size_t leg, MetresPerSecond speed, const Sentence& sentence,
                 const Parts& parts) {
    Fault& fault = tell(FaultKind::RouteFasterThanZone, Severity::Warning, sentence, parts);
    fault.objects.push_back({ObjectKind::Zone, zone.name});
    if (*zone.speed >= floor::kLeastLegSpeed)
      fault.fix = Fix{phrase("Core", "Slow leg %1 of route \"%2\" down to %3 m/s")
                          .with(leg + 1, route_.name, figure(zone.speed->value(), 2)),
                      SetLegSpeed{route_.name, leg, speed, *zone.speed}};
    return fault;
  }

  // Which of the route's vertices one of the line is, of those at one point the first. From 0.
  [[nodiscard]] std::size_t numberOf(std::size_t vertex) const {
    std::size_t number = 0;
    for (std::size_t v = 0; v <= vertex; ++v, ++number)
      while (number + 1 < route_.vertices.size() && route_.vertices[number] != line_.vertices()[v]) ++number;
    return number - 1;
  }

  const Context& context_;
  const Route& route_;
  const Polyline& line_;
  std::vector<RoundWay> ways_;
  ZoneVerdict verdict_;
};

}  // namespace

bool ZoneVerdict::isOnFloor(const VehicleSetup& vehicle) const {
  return lineOnFloor && std::find(cutsOffIt.begin(), cutsOffIt.end(), vehicle.cornerCut) == cutsOffIt.end();
}

ZoneVerdict zoneVerdictOf(const Context& context, const Route& route, const Polyline& line) {
  return Judge{context, route, line}.judge();
}

}  // namespace tessera::sitecheck
