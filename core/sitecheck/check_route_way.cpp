// Routes against the vehicles that would follow them, and what their bodies need of the zones.
#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "base/polyline.h"
#include "base/rounded_line.h"
#include "floor/route_legs.h"
#include "sitecheck/body.h"
#include "sitecheck/checks.h"
#include "sitecheck/outline.h"
#include "sitecheck/route_zones.h"
#include "sitecheck/wording.h"

namespace tessera::sitecheck {
namespace {

using floor::Route;
using floor::VehicleSetup;
using region::Region;

constexpr Metres kNarrow{0.005};  // what sticks out by less is drawn along an edge

Fault routeFault(FaultKind kind, Severity severity, const Route& route, const Sentence& sentence) {
  return {kind, severity, sentence, {}, {{ObjectKind::Route, route.name}}, {}};
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
    const ZoneVerdict zones = zoneVerdictOf(context_, route_, line_);
    faults_.insert(faults_.end(), zones.faults.begin(), zones.faults.end());
    for (const VehicleSetup* v : bodiesOf(context_.site)) {
      tooTight(*v);
      if (zones.isOnFloor(*v)) tooClose(*v);
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
    for (std::size_t leg = 0; leg < way.legCount(); ++leg) {
      const Point a = way.vertices()[leg];
      const Point b = way.vertices()[leg + 1];
      const double heading = way.headingOf(leg).value();
      parts.push_back(facing(a, heading).swept(b - a));
      if (leg + 1 == way.legCount()) break;
      const double turn = turnBetween(way.headingOf(leg), way.headingOf(leg + 1)).value();
      const int steps = static_cast<int>(std::ceil(std::abs(turn) / 0.1));
      for (int i = 1; i < steps; ++i) parts.push_back(facing(b, heading + turn * i / steps));
    }
    return Region::unionOf(parts);
  }

  void tooClose(const VehicleSetup& v) {
    const Metres clearance = context_.options.clearance;
    const Region body = sweptBy(v);
    const Region swept = clearance > Metres{} ? body.grown(clearance) : body;
    const Region off =
        (context_.zones.anyRunning ? swept - context_.zones.drivable : swept & context_.zones.noGo).opened(kNarrow);
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
