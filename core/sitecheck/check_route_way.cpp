// Routes against the zones and the vehicles that would follow them.
#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "base/polyline.h"
#include "base/rounded_line.h"
#include "floor/route_legs.h"
#include "sitecheck/body.h"
#include "sitecheck/checks.h"
#include "sitecheck/outline.h"
#include "sitecheck/wording.h"

namespace tessera::sitecheck {
namespace {

using floor::Route;
using floor::VehicleSetup;
using floor::ZoneKind;
using region::Region;
using region::Stretch;

constexpr Metres kSliver{0.005};  // shorter ways outside are a line drawn along an edge

Fault routeFault(FaultKind kind, Severity severity, const Route& route, const Sentence& sentence) {
  return {kind, severity, sentence, {}, {{ObjectKind::Route, route.name}}, {}};
}

// Length of a way's parts, and the box around them.
struct Parts {
  Metres length;
  std::optional<Box> place;
  void add(Point from, Point to, const Stretch& s) {
    const Point ends[] = {from + s.from * (to - from), from + s.to * (to - from)};
    length += distance(ends[0], ends[1]);
    place = place ? boxAround(*place, boxAround(ends)) : boxAround(ends);
  }
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

class Way {
public:
  Way(const Context& context, const Route& route)
      : context_{context}, route_{route}, line_{withoutRepeats(route.vertices, false)} {
    Route tidied = route;
    keepVertices(tidied, line_.vertices());
    for (std::size_t leg = 0; leg < line_.legCount(); ++leg) speeds_.push_back(floor::legSpeed(tidied, leg));
  }

  Faults check() {
    shape();
    if (line_.legCount() == 0) return std::move(faults_);
    noGo();
    running();
    oneWays();
    slowZones();
    for (const VehicleSetup* v : bodiesOf(context_.site)) {
      tooTight(*v);
      if (onFloor_) tooClose(*v);
    }
    return std::move(faults_);
  }

private:
  Fault& tell(FaultKind kind, Severity severity, const Sentence& sentence, const std::optional<Box>& place) {
    faults_.push_back(routeFault(kind, severity, route_, sentence));
    if (place && isPlace(*place)) faults_.back().place = place;
    return faults_.back();
  }

  void shape() {
    const auto all = route_.vertices.empty() ? std::nullopt : std::optional{boxAround(route_.vertices)};
    if (line_.legCount() == 0) {
      tell(FaultKind::RouteTooShort, Severity::Error,
           phrase("Core", "Route \"%1\" has fewer than two different points.").with(route_.name), all);
    } else if (line_.vertices().size() != route_.vertices.size()) {
      tell(FaultKind::RouteRepeatsPoint, Severity::Warning,
           phrase("Core", "Route \"%1\" has the same point twice in a row.").with(route_.name), all)
          .fix = Fix{phrase("Core", "Take the repeated points out of route \"%1\"").with(route_.name),
                     ReplaceVertices{route_.name, route_.vertices, line_.vertices()}};
    }
  }

  void noGo() {
    for (std::size_t i = 0; i < context_.site.zones.size(); ++i) {
      const floor::Zone& zone = context_.site.zones[i];
      if (zone.kind != ZoneKind::NoGo) continue;
      const Parts parts = inside(line_, context_.zones.areas[i].grown(-1.0 * kSliver));
      if (parts.length <= kSliver) continue;
      onFloor_ = false;
      tell(FaultKind::RouteCrossesNoGo, Severity::Error,
           phrase("Core", "Route \"%1\" leads %2 m through the no-go zone \"%3\".")
               .with(route_.name, inMetres(parts.length), zone.name),
           parts.place)
          .objects.push_back({ObjectKind::Zone, zone.name});
    }
  }

  void running() {
    if (!context_.zones.anyRunning || !onFloor_) return;
    const Parts parts = outside(line_, context_.zones.drivable);
    if (parts.length <= kSliver) return;
    onFloor_ = false;
    tell(FaultKind::RouteLeavesRunningZone, Severity::Error,
         phrase("Core", "Route \"%1\" leads %2 m outside the zones in which vehicles may be.")
             .with(route_.name, inMetres(parts.length)),
         parts.place);
  }

  void oneWays() {
    for (std::size_t i = 0; i < context_.site.zones.size(); ++i) {
      const floor::Zone& zone = context_.site.zones[i];
      if (zone.kind != ZoneKind::OneWay || !zone.direction) continue;
      Parts parts;
      forEachLeg(line_, [&](std::size_t leg, Point a, Point b) {
        if (abs(turnBetween(*zone.direction, line_.headingOf(leg))) <= Radians{kPi / 2 + 1e-6}) return;
        for (const Stretch& s : context_.zones.areas[i].within(a, b)) parts.add(a, b, s);
      });
      if (parts.length <= kSliver) continue;
      tell(FaultKind::RouteAgainstOneWay, Severity::Error,
           phrase("Core", "Route \"%1\" leads %2 m the wrong way through the one-way zone \"%3\".")
               .with(route_.name, inMetres(parts.length), zone.name),
           parts.place)
          .objects.push_back({ObjectKind::Zone, zone.name});
    }
  }

  void slowZones() {
    for (std::size_t i = 0; i < context_.site.zones.size() && !route_.legSpeeds.empty(); ++i) {
      const floor::Zone& zone = context_.site.zones[i];
      if (zone.kind != ZoneKind::Slow || !zone.speed) continue;
      for (std::size_t leg = 0; leg < floor::legCount(route_); ++leg) {
        const auto speed = floor::legSpeed(route_, leg);
        if (!speed || *speed <= *zone.speed) continue;
        const Polyline line{{route_.vertices[leg], route_.vertices[leg + 1]}};
        if (const Parts parts = inside(line, context_.zones.areas[i]); parts.length > kSliver)
          tooFast(zone, leg, *speed, parts);
      }
    }
  }

  void tooFast(const floor::Zone& zone, std::size_t leg, MetresPerSecond speed, const Parts& parts) {
    Fault& fault =
        tell(FaultKind::RouteFasterThanZone, Severity::Warning,
             phrase("Core",
                    "Leg %1 of route \"%2\" may be driven at %3 m/s, but leads through the slow zone \"%4\" of %5 m/s.")
                 .with(leg + 1, route_.name, figure(speed.value(), 2), zone.name, figure(zone.speed->value(), 2)),
             parts.place);
    fault.objects.push_back({ObjectKind::Zone, zone.name});
    if (*zone.speed >= floor::kLeastLegSpeed)
      fault.fix = Fix{phrase("Core", "Slow leg %1 of route \"%2\" down to %3 m/s")
                          .with(leg + 1, route_.name, figure(zone.speed->value(), 2)),
                      SetLegSpeed{route_.name, leg, speed, *zone.speed}};
  }

  // As fast as the vehicle may be where a leg ends and the next begins.
  [[nodiscard]] MetresPerSecond speedAt(std::size_t vertex, const VehicleSetup& v) const {
    const auto on = [&](std::size_t leg) { return std::min(v.maxSpeed, speeds_[leg].value_or(v.maxSpeed)); };
    return std::max(on(vertex - 1), on(vertex));
  }

  // Bends that are not sharp are driven without stopping: how fast they turn the vehicle, at its full speed.
  void tooTight(const VehicleSetup& v) {
    double worst = v.maxTurnRate.value() * 1.001;
    std::optional<std::size_t> at;
    for (std::size_t i = 1; i < line_.legCount(); ++i) {
      const double turn = std::abs(turnBetween(line_.headingOf(i - 1), line_.headingOf(i)).value());
      if (turn >= context_.options.sharpCorner.value()) continue;
      const Metres over = 0.5 * (line_.startOf(i + 1) - line_.startOf(i - 1));
      const double rate = speedAt(i, v).value() * turn / over.value();
      if (rate > worst) {
        worst = rate;
        at = i;
      }
    }
    if (!at) return;
    const Point place = line_.vertices()[*at];
    Fault& fault =
        tell(FaultKind::RouteTooTight, Severity::Warning,
             phrase("Core",
                    "At %2 m route \"%1\" bends faster than %3 can turn at its full speed: %4 rad/s instead of "
                    "%5 rad/s.")
                 .with(route_.name, placeText(place), nameOf(v), figure(worst, 2), figure(v.maxTurnRate.value(), 2)),
             Box{place, place});
    addTo(fault.objects, v);
  }

  // The outline carried along every leg of the way that it drives, and turned on the spot at every vertex in steps of a
  // few degrees.
  [[nodiscard]] Region sweptBy(const VehicleSetup& v) const {
    std::vector<Region> parts;
    const auto facing = [&](Point place, double heading) {
      std::vector<Point> outline;
      for (const Point& p : v.footprint) outline.push_back(placeOf({place, Radians{heading}}, {p.x, p.y}));
      return Region::of(outline);
    };
    const Polyline way = RoundedLine{line_, v.cornerCut, context_.options.sharpCorner}.line();
    forEachLeg(way, [&](std::size_t leg, Point a, Point b) {
      const double heading = way.headingOf(leg).value();
      parts.push_back(facing(a, heading).swept(b - a));
      if (leg + 1 == way.legCount()) return;
      const double turn = turnBetween(way.headingOf(leg), way.headingOf(leg + 1)).value();
      const int steps = static_cast<int>(std::ceil(std::abs(turn) / 0.1));
      for (int i = 1; i < steps; ++i) parts.push_back(facing(b, heading + turn * i / steps));
    });
    return Region::unionOf(parts);
  }

  void tooClose(const VehicleSetup& v) {
    const Metres clearance = context_.options.clearance;
    const Region body = sweptBy(v);
    const Region swept = clearance > Metres{} ? body.grown(clearance) : body;
    const Region off =
        (context_.zones.anyRunning ? swept - context_.zones.drivable : swept & context_.zones.noGo).opened(kSliver);
    if (off.empty()) return;
    const Sentence sentence =
        clearance > Metres{}
            ? phrase("Core",
                     "On route \"%1\" %2 with %5 m of room around it sticks out of the zones in which it may "
                     "be, over %3 m² about %4 m.")
                  .with(route_.name, nameOf(v), figure(off.squareMetres(), 2), placeText(middleOf(off.bounds())),
                        inMetres(clearance))
            : phrase("Core", "On route \"%1\" %2 sticks out of the zones in which it may be, over %3 m² about %4 m.")
                  .with(route_.name, nameOf(v), figure(off.squareMetres(), 2), placeText(middleOf(off.bounds())));
    addTo(tell(FaultKind::RouteTooClose, Severity::Warning, sentence, off.bounds()).objects, v);
  }

  const Context& context_;
  const Route& route_;
  Polyline line_;
  std::vector<std::optional<MetresPerSecond>> speeds_;  ///< of the line's legs
  Faults faults_;
  bool onFloor_ = true;  ///< the line itself is where vehicles may be
};

}  // namespace

Faults checkRouteWay(const Context& context, const Route& route) { return Way{context, route}.check(); }

Faults checkRouteNames(const Context& context) {
  Faults faults;
  std::unordered_set<std::string_view> names;
  for (const Route& route : context.site.routes) {
    if (!names.insert(route.name).second)
      faults.push_back(routeFault(FaultKind::RouteTwice, Severity::Error, route,
                                  phrase("Core", "Two routes are called \"%1\".").with(route.name)));
  }
  return faults;
}

}  // namespace tessera::sitecheck
