// Zones upon one another that say opposite things, and places that no way leads to. The rules stand in
// docs/site-format.md.
#include <algorithm>

#include "sitecheck/checks.h"
#include "sitecheck/wording.h"

namespace tessera::sitecheck {
namespace {

using floor::Zone;
using floor::ZoneKind;

constexpr double kNoOverlap = 1e-4;  // m²

bool isGoal(ZoneKind kind) {
  return kind == ZoneKind::Parking || kind == ZoneKind::Charging || kind == ZoneKind::Storage;
}

// No-go wins over `other`.
void against(const Zone& noGo, const Zone& other, const region::Region& common, double otherArea, Faults& faults) {
  const bool all = common.squareMetres() > 0.999 * otherArea;
  if (!all && !isGoal(other.kind)) return;  // a pillar in a hall
  Fault fault{FaultKind::ZonesContradict,
              all && isGoal(other.kind) ? Severity::Error : Severity::Warning,
              {},
              common.bounds(),
              {{ObjectKind::Zone, other.name}, {ObjectKind::Zone, noGo.name}},
              {}};
  fault.sentence =
      all ? phrase("Core", "Zone \"%1\" lies wholly in the no-go zone \"%2\", which wins: it has no effect.")
                .with(other.name, noGo.name)
          : phrase("Core", "%1 m² of zone \"%2\" lie in the no-go zone \"%3\", which wins.")
                .with(figure(common.squareMetres(), 2), other.name, noGo.name);
  faults.push_back(std::move(fault));
}

void oneWays(const Zone& a, const Zone& b, const region::Region& common, Faults& faults) {
  if (!a.direction || !b.direction) return;
  const Radians turn = abs(turnBetween(*a.direction, *b.direction));
  if (turn <= Radians{kPi / 2 + 1e-9}) return;
  faults.push_back({FaultKind::ZonesContradict,
                    Severity::Error,
                    phrase("Core", "The one-way zones \"%1\" and \"%2\" overlap and lead %3° apart.")
                        .with(a.name, b.name, figure(degrees(turn), 0)),
                    common.bounds(),
                    {{ObjectKind::Zone, a.name}, {ObjectKind::Zone, b.name}},
                    {}});
}

void stack(const Context& context, std::size_t i, std::size_t j, Faults& faults) {
  const Zone& a = context.site.zones[i];
  const Zone& b = context.site.zones[j];
  const bool noGo = (a.kind == ZoneKind::NoGo) != (b.kind == ZoneKind::NoGo);
  const bool ways = a.kind == ZoneKind::OneWay && b.kind == ZoneKind::OneWay;
  if (!noGo && !ways) return;
  const region::Region common = context.zones.areas[i] & context.zones.areas[j];
  if (!(common.squareMetres() > kNoOverlap)) return;
  if (ways)
    oneWays(a, b, common, faults);
  else if (a.kind == ZoneKind::NoGo)
    against(a, b, common, context.zones.areas[j].squareMetres(), faults);
  else
    against(b, a, common, context.zones.areas[i].squareMetres(), faults);
}

}  // namespace

Faults checkZoneStacking(const Context& context) {
  Faults faults;
  std::vector<Box> boxes;
  std::vector<std::size_t> zoneOf;
  for (std::size_t i = 0; i < context.zones.areas.size(); ++i) {
    if (context.zones.areas[i].empty()) continue;
    boxes.push_back(context.zones.areas[i].bounds());
    zoneOf.push_back(i);
  }
  const region::BoxTree tree{boxes};
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    near.clear();
    tree.forEachIn(boxes[i], [&](std::size_t j) {
      if (j > i) near.push_back(j);
    });
    std::sort(near.begin(), near.end());
    for (const std::size_t j : near) stack(context, zoneOf[i], zoneOf[j], faults);
  }
  return faults;
}

Faults checkReach(const Context& context) {
  Faults faults;
  const bool anyGoal =
      std::any_of(context.site.zones.begin(), context.site.zones.end(), [](const Zone& z) { return isGoal(z.kind); });
  if (!anyGoal || !context.zones.anyRunning) return faults;
  // Parts that hang together by more than a passage; those with running zone in them can be reached.
  std::vector<region::Region> reachable;
  for (region::Region& part : context.zones.drivable.grown(-0.5 * context.options.passage).pieces())
    if ((part & context.zones.running).squareMetres() > kNoOverlap) reachable.push_back(std::move(part));
  for (std::size_t i = 0; i < context.site.zones.size(); ++i) {
    const Zone& zone = context.site.zones[i];
    const region::Region& area = context.zones.areas[i];
    if (!isGoal(zone.kind) || area.empty()) continue;
    const bool reached = std::any_of(reachable.begin(), reachable.end(), [&](const region::Region& part) {
      return (part & area).squareMetres() > kNoOverlap;
    });
    if (reached) continue;
    faults.push_back({FaultKind::ZoneUnreachable,
                      Severity::Error,
                      phrase("Core", "No way leads from a running zone into zone \"%1\".").with(zone.name),
                      area.bounds(),
                      {{ObjectKind::Zone, zone.name}},
                      {}});
  }
  return faults;
}

Faults checkGaps(const Context& context, std::size_t index) {
  Faults faults;
  const Zone& zone = context.site.zones[index];
  if (zone.kind != ZoneKind::Running || context.plan.laid().empty()) return faults;
  const region::Region open = context.zones.areas[index] - context.zones.noGo;
  // The tiles are half a seam wider than they are, and so close what is told as tiles off their lattice; what is left
  // gets its border back.
  const Metres half = 0.5 * context.options.seam;
  const region::Region holes = (open - context.plan.covered()).opened(half + Metres{0.001}).grown(half) & open;
  FaultList gaps{faults, FaultKind::ZoneGap, Severity::Warning, context.options.mostOfAKind};
  for (const region::Region& hole : holes.pieces()) {
    const double area = hole.squareMetres();
    if (area < context.options.leastGap) continue;
    gaps.add(hole.bounds(), [&] {
      return Fault{.sentence = phrase("Core", "%1 m² of the running zone \"%2\" at %3 m have no tiles.")
                                   .with(figure(area, 2), zone.name, placeText(middleOf(hole.bounds()))),
                   .objects = {{ObjectKind::Zone, zone.name}}};
    });
  }
  gaps.close();
  return faults;
}

}  // namespace tessera::sitecheck
