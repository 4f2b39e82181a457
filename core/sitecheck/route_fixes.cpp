// Edits that mend a route: reversed, slower in its bends, vertices moved to where there is room. Each is tried on a
// copy before it is offered.
#include <algorithm>
#include <cmath>

#include "base/polyline.h"
#include "floor/route_legs.h"
#include "sitecheck/body.h"
#include "sitecheck/checks.h"
#include "sitecheck/outline.h"
#include "sitecheck/wording.h"

namespace tessera::sitecheck {
namespace {

using floor::Route;
using floor::VehicleSetup;
using region::Region;

constexpr Metres kFarthestShift{1.0};          // farther the route would be another one
constexpr MetresPerSecond kSlowestBend{0.05};  // slower it would creep: that way wants to be drawn otherwise
constexpr Metres kTidy{0.001};                 // vertices are moved to whole millimetres

bool alike(const Fault& a, const Fault& b) { return a.kind == b.kind && a.objects == b.objects; }

std::ptrdiff_t countAlike(const Faults& faults, const Fault& like) {
  return std::count_if(faults.begin(), faults.end(), [&](const Fault& f) { return alike(f, like); });
}

class Mender {
public:
  Mender(const Context& context, const Route& route, const Faults& faults)
      : context_{context}, route_{route}, faults_{faults} {}

  [[nodiscard]] std::optional<Fix> fixOf(const Fault& fault) const {
    switch (fault.kind) {
      case FaultKind::RouteAgainstOneWay:
        return reversed(fault);
      case FaultKind::RouteTooTight:
        return slowedDown(fault);
      case FaultKind::RouteLeavesRunningZone:
      case FaultKind::RouteCrossesNoGo:
      case FaultKind::RouteTooClose:
        return movedInside(fault);
      default:
        return std::nullopt;
    }
  }

private:
  // The fault goes, and nothing comes that weighs as much.
  [[nodiscard]] bool mends(const Route& changed, const Fault& fault) const {
    const Faults after = checkRouteWay(context_, changed);
    if (countAlike(after, fault) >= countAlike(faults_, fault)) return false;
    return std::all_of(after.begin(), after.end(), [&](const Fault& f) {
      return f.severity < fault.severity || countAlike(after, f) <= countAlike(faults_, f);
    });
  }

  [[nodiscard]] std::optional<Fix> reversed(const Fault& fault) const {
    Route changed = route_;
    reverse(changed);
    if (!mends(changed, fault)) return std::nullopt;
    return Fix{phrase("Core", "Reverse route \"%1\"").with(route_.name), ReverseRoute{route_}};
  }

  [[nodiscard]] std::optional<Fix> slowedDown(const Fault& fault) const {
    const Polyline line{route_.vertices};
    // With points twice in a row the legs have other numbers: those points have a fault, and a fix, of their own.
    if (line.vertices().size() != route_.vertices.size()) return std::nullopt;
    Route changed = route_;
    std::optional<MetresPerSecond> slowest;
    for (const VehicleSetup* v : bodiesOf(context_.site)) {
      if (!isOf(fault, *v)) continue;
      for (std::size_t i = 1; i < line.legCount(); ++i) {
        const double turn = std::abs(turnBetween(line.headingOf(i - 1), line.headingOf(i)).value());
        if (turn == 0.0 || turn >= context_.options.sharpCorner.value()) continue;
        const double over = 0.5 * (line.startOf(i + 1) - line.startOf(i - 1)).value();
        // Down to whole centimetres a second, as people read it.
        const MetresPerSecond most{std::floor(100.0 * v->maxTurnRate.value() * over / turn) / 100.0};
        for (const std::size_t leg : {i - 1, i}) {
          if (std::min(v->maxSpeed, legSpeed(changed, leg).value_or(v->maxSpeed)) <= most) continue;
          if (most < kSlowestBend) return std::nullopt;
          setLegSpeed(changed, leg, most);
          slowest = slowest ? std::min(*slowest, most) : most;
        }
      }
    }
    if (!slowest || !mends(changed, fault)) return std::nullopt;
    return Fix{phrase("Core", "Slow route \"%1\" down in its bends, to %2 m/s in the tightest")
                   .with(route_.name, figure(slowest->value(), 2)),
               SetLegSpeeds{route_, changed.legSpeeds}};
  }

  // How far from a vertex a vehicle reaches: aside while it drives straight on, and all around when it turns there.
  struct Reach {
    Metres aside;
    Metres around;
  };
  [[nodiscard]] Reach reachOf(const Fault& fault) const {
    Reach reach;
    const bool all = fault.kind != FaultKind::RouteTooClose;
    for (const VehicleSetup* v : bodiesOf(context_.site)) {
      if (!all && !isOf(fault, *v)) continue;
      for (const Point& p : v->footprint) {
        reach.aside = std::max(reach.aside, Metres{std::abs(p.y.value())});
        reach.around = std::max(reach.around, length({p.x, p.y}));
      }
    }
    return {reach.aside + context_.options.clearance, reach.around + context_.options.clearance};
  }

  [[nodiscard]] std::optional<Fix> movedInside(const Fault& fault) const {
    if (!fault.place || !isPlace(boxAround(route_.vertices))) return std::nullopt;
    const auto [aside, around] = reachOf(fault);
    // Of a line that lies wrongly, at best to where the vehicle has room too; of a body too near, as little as does.
    const bool line = fault.kind != FaultKind::RouteTooClose;
    const Metres tries[] = {line ? around : aside, line ? aside : 0.5 * (aside + around), line ? Metres{} : around};
    for (const Metres room : tries)
      if (auto fix = movedInside(fault, room, grown(*fault.place, around + kTidy))) return fix;
    return std::nullopt;
  }

  [[nodiscard]] std::optional<Fix> movedInside(const Fault& fault, Metres room, const Box& about) const {
    const ZonePlan& zones = context_.zones;
    const Region area = zones.anyRunning ? zones.drivable.grown(-1.0 * (room + kTidy)) : zones.noGo.grown(room + kTidy);
    if (area.empty()) return std::nullopt;
    Route changed = route_;
    std::size_t moved = 0;
    std::size_t last = 0;
    Metres farthest;
    for (std::size_t i = 0; i < changed.vertices.size(); ++i) {
      Point& vertex = changed.vertices[i];
      if (!meet(about, {vertex, vertex}) || area.contains(vertex) == zones.anyRunning) continue;
      const Point target = area.nearestOnEdge(vertex);
      const auto whole = [](Metres m) { return Metres{std::round(m.value() * 1e3) / 1e3}; };
      const Point place{whole(target.x), whole(target.y)};
      farthest = std::max(farthest, distance(vertex, place));
      if (farthest > kFarthestShift) return std::nullopt;
      vertex = place;
      last = i;
      ++moved;
    }
    const auto points = [](const Route& r) { return withoutRepeats(r.vertices, false).size(); };
    if (moved == 0 || points(changed) < points(route_) || !mends(changed, fault)) return std::nullopt;
    const Sentence order =
        moved == 1 ? phrase("Core", "Move vertex %2 of route \"%1\" by %3 m, to where there is room")
                         .with(route_.name, last + 1, inMetres(farthest))
                   : phrase("Core", "Move %2 vertices of route \"%1\" by up to %3 m, to where there is room")
                         .with(route_.name, moved, inMetres(farthest));
    return Fix{order, MoveVertices{route_.name, route_.vertices, changed.vertices}};
  }

  const Context& context_;
  const Route& route_;
  const Faults& faults_;
};

}  // namespace

void offerRouteFixes(const Context& context, const Route& route, Faults& faults) {
  if (route.vertices.size() < 2) return;
  const Faults found = faults;
  const Mender mender{context, route, found};
  for (Fault& fault : faults)
    if (!fault.fix) fault.fix = mender.fixOf(fault);
}

}  // namespace tessera::sitecheck
