// Zones that are no proper areas, or lack what their kind needs.
#include <cmath>
#include <unordered_set>

#include "sitecheck/checks.h"
#include "sitecheck/outline.h"
#include "sitecheck/wording.h"

namespace tessera::sitecheck {
namespace {

constexpr double kNoArea = 1e-4;  // m²: a square of one centimetre

Fault zoneFault(FaultKind kind, Severity severity, const floor::Zone& zone, const Sentence& sentence) {
  Fault fault{kind, severity, sentence, {}, {{ObjectKind::Zone, zone.name}}, {}};
  if (!zone.outline.empty() && isPlace(boxAround(zone.outline))) fault.place = boxAround(zone.outline);
  return fault;
}

void outline(const floor::Zone& zone, const region::Region& area, Faults& faults) {
  if (std::vector<Point> clean = withoutRepeats(zone.outline, true);
      clean.size() != zone.outline.size() && clean.size() >= 3) {
    Fault fault = zoneFault(
        FaultKind::ZoneRepeatsPoint, Severity::Warning, zone,
        phrase("Core",
               "The outline of zone \"%1\" has the same point twice in a row; it closes by itself, without its "
               "first point at the end.")
            .with(zone.name));
    fault.fix = Fix{phrase("Core", "Take the repeated points out of zone \"%1\"").with(zone.name),
                    ReplaceOutline{zone.name, zone.outline, std::move(clean)}};
    faults.push_back(std::move(fault));
  }
  if (!(area.squareMetres() >= kNoArea)) {
    faults.push_back(zoneFault(FaultKind::ZoneWithoutArea, Severity::Error, zone,
                               phrase("Core", "Zone \"%1\" has no area.").with(zone.name)));
    return;
  }
  const auto crossing = firstCrossing(zone.outline);
  // Where lines only touch, or run over one another, the area tells: what lies inside twice is outside.
  const bool folded = std::abs(std::abs(drawnArea(zone.outline)) - area.squareMetres()) > kNoArea;
  if (!crossing && !folded) return;
  Fault fault =
      zoneFault(FaultKind::ZoneCrossesItself, Severity::Error, zone,
                phrase("Core", "The outline of zone \"%1\" crosses itself: what it encloses twice lies outside.")
                    .with(zone.name));
  if (crossing) fault.place = Box{*crossing, *crossing};
  faults.push_back(std::move(fault));
}

}  // namespace

Faults checkZoneShapes(const Context& context) {
  Faults faults;
  std::unordered_set<std::string_view> names;
  for (std::size_t i = 0; i < context.site.zones.size(); ++i) {
    const floor::Zone& zone = context.site.zones[i];
    if (!names.insert(zone.name).second)
      faults.push_back(zoneFault(FaultKind::ZoneTwice, Severity::Warning, zone,
                                 phrase("Core", "Two zones are called \"%1\".").with(zone.name)));
    outline(zone, context.zones.areas[i], faults);
    if (zone.kind == floor::ZoneKind::Slow && !(zone.speed && zone.speed->value() > 0.0))
      faults.push_back(zoneFault(
          FaultKind::ZoneWithoutSpeed, Severity::Error, zone,
          phrase("Core", "The slow zone \"%1\" does not say how fast vehicles may go in it.").with(zone.name)));
    if (zone.kind == floor::ZoneKind::OneWay && !zone.direction)
      faults.push_back(zoneFault(FaultKind::ZoneWithoutDirection, Severity::Error, zone,
                                 phrase("Core", "The one-way zone \"%1\" does not say which way.").with(zone.name)));
  }
  return faults;
}

}  // namespace tessera::sitecheck
