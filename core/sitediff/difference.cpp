#include "sitediff/difference.h"

#include <array>

#include "base/polyline.h"
#include "floor/route_legs.h"
#include "floor/site_names.h"
#include "sitediff/matching.h"

namespace tessera::sitediff {
namespace {

using floor::Route;
using floor::Site;
using floor::VehicleSetup;
using floor::Zone;

std::optional<Box> around(const std::vector<Point>& points) {
  return points.empty() ? std::nullopt : std::optional{boxAround(points)};
}

void whole(const Site& a, const Site& b, Changes& changes) {
  Teller site{changes, Subject::Site};
  if (a.name != b.name)
    site.tell(ChangeKind::Changed, b.name,
              phrase("Core", "The site is called \"%1\" instead of \"%2\".").with(b.name, a.name), {});
  if (a.northToY != b.northToY)
    site.tell(ChangeKind::Changed, b.name,
              phrase("Core", "The site's y axis points %1° from north instead of %2°.")
                  .with(decimals(degrees(b.northToY), 2), decimals(degrees(a.northToY), 2)),
              {});
  if (a.radio != b.radio)
    Teller{changes, Subject::Radio}.tell(
        ChangeKind::Changed, "radio",
        phrase("Core", "The radio uses channel %1, %2 bit/s, %3 baud instead of channel %4, %5 bit/s, %6 baud.")
            .with(b.radio.channel, decimals(b.radio.airRate, 0), b.radio.baud, a.radio.channel,
                  decimals(a.radio.airRate, 0), a.radio.baud),
        {});
}

// The same outline elsewhere; nullopt: another outline.
std::optional<Offset> shift(const std::vector<Point>& a, const std::vector<Point>& b) {
  if (a.empty() || a.size() != b.size()) return std::nullopt;
  const Offset by = b[0] - a[0];
  for (std::size_t i = 0; i < a.size(); ++i)
    if (length((b[i] - a[i]) + -1.0 * by) > Metres{1e-9}) return std::nullopt;
  return by;
}

void zones(const Zone& a, const Zone& b, Teller& tell) {
  const Sentence who = phrase("Core", "Zone \"%1\"").with(b.name);
  const auto place = around(b.outline);
  if (a.kind != b.kind)
    tell.changed(b.name, who,
                 phrase("Core", "kind \"%1\" instead of \"%2\"")
                     .with(std::string{floor::kZoneKindNames.at(static_cast<std::size_t>(b.kind))},
                           std::string{floor::kZoneKindNames.at(static_cast<std::size_t>(a.kind))}),
                 place);
  if (a.outline != b.outline) {
    if (shift(a.outline, b.outline))
      tell.moved(b.name, who, a.outline[0], b.outline[0]);
    else
      tell.changed(b.name, who, phrase("Core", "another outline"), place);
  }
  if (a.speed != b.speed) tell.changed(b.name, who, phrase("Core", "another speed"), place);
  if (a.direction != b.direction) tell.changed(b.name, who, phrase("Core", "another direction"), place);
}

std::string speedText(MetresPerSecond speed) { return decimals(speed.value(), 3); }

// What became of the speed of one leg; leg counted from 1 as people do.
Sentence legSpeedChange(std::size_t leg, std::optional<MetresPerSecond> a, std::optional<MetresPerSecond> b) {
  if (!a) return phrase("Core", "at most %2 m/s on leg %1").with(leg, speedText(*b));
  if (!b) return phrase("Core", "no highest speed on leg %1 any more").with(leg);
  return phrase("Core", "at most %2 m/s instead of %3 m/s on leg %1").with(leg, speedText(*b), speedText(*a));
}

// Legs are told one by one where they are the same legs and few have changed.
void legSpeeds(const Route& a, const Route& b, const Sentence& who, Teller& tell) {
  if (a.legSpeeds == b.legSpeeds) return;
  constexpr std::size_t kFew = 5;
  std::vector<std::size_t> changed;
  for (std::size_t leg = 0; leg < std::max(floor::legCount(a), floor::legCount(b)); ++leg)
    if (floor::legSpeed(a, leg) != floor::legSpeed(b, leg)) changed.push_back(leg);
  if (a.vertices.size() != b.vertices.size() || changed.size() > kFew)
    return tell.changed(b.name, who, phrase("Core", "other highest speeds on its legs"), around(b.vertices));
  for (const std::size_t leg : changed)
    tell.changed(b.name, who, legSpeedChange(leg + 1, floor::legSpeed(a, leg), floor::legSpeed(b, leg)),
                 boxAround(std::vector{b.vertices[leg], b.vertices[leg + 1]}));
}

void routes(const Route& a, const Route& b, Teller& tell) {
  const Sentence who = phrase("Core", "Route \"%1\"").with(b.name);
  if (a.vertices != b.vertices)
    tell.changed(b.name, who,
                 phrase("Core", "another way, %1 m instead of %2 m")
                     .with(decimals(Polyline{b.vertices}.length().value(), 2),
                           decimals(Polyline{a.vertices}.length().value(), 2)),
                 around(b.vertices));
  if (a.controlSpacing != b.controlSpacing)
    tell.changed(b.name, who, phrase("Core", "another distance of control points"), around(b.vertices));
  legSpeeds(a, b, who, tell);
}

void vehicles(const VehicleSetup& a, const VehicleSetup& b, Teller& tell) {
  const std::string address = std::to_string(b.id.value);
  const Sentence who = phrase("Core", "Vehicle \"%1\"").with(b.name);
  if (a.name != b.name) tell.changed(address, who, phrase("Core", "was called \"%1\"").with(a.name), {});
  if (a.key != b.key) tell.changed(address, who, phrase("Core", "another key"), {});
  if (a.start != b.start) tell.changed(address, who, phrase("Core", "another start"), {});
  VehicleSetup like = a;
  like.name = b.name;
  like.key = b.key;
  like.start = b.start;
  if (!(like == b)) tell.changed(address, who, phrase("Core", "another shape, other readers or other abilities"), {});
}

// Its extent is known to who decodes the picture: no place is told.
void backdrops(const std::optional<floor::Backdrop>& a, const std::optional<floor::Backdrop>& b, Changes& changes) {
  if (a == b) return;
  Teller tell{changes, Subject::Backdrop};
  const std::string& name = b ? b->file : a->file;
  const Sentence who = phrase("Core", "Floor plan \"%1\"").with(name);
  if (!a) return tell.added(name, who, {});
  if (!b) return tell.removed(name, who, {});
  floor::Backdrop placed = *a;
  placed.picture = b->picture;
  placed.file = b->file;
  if (!(placed == *a)) tell.changed(name, who, phrase("Core", "another picture"), {});
  if (a->origin != b->origin) tell.moved(name, who, a->origin, b->origin);
  if (a->pixel != b->pixel || a->turn != b->turn)
    tell.changed(name, who, phrase("Core", "another scale or direction"), {});
  if (a->opacity != b->opacity) tell.changed(name, who, phrase("Core", "another opacity"), {});
}

}  // namespace

std::string_view codeOf(ChangeKind kind) {
  constexpr std::array<std::string_view, 4> names{"added", "removed", "moved", "changed"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string_view codeOf(Subject subject) {
  constexpr std::array<std::string_view, 9> names{"site", "radio", "tile-type", "tile",    "loose-tag",
                                                  "zone", "route", "vehicle",   "backdrop"};
  return names.at(static_cast<std::size_t>(subject));
}

Changes difference(const Site& before, const Site& after) {
  Changes changes;
  whole(before, after, changes);
  tileDifference(before, after, changes);
  match(
      before.zones, after.zones, [](const Zone& z) { return std::string_view{z.name}; },
      [tell = Teller{changes, Subject::Zone}](const Zone* a, const Zone* b) mutable {
        const Zone& any = a != nullptr ? *a : *b;
        const Sentence who = phrase("Core", "Zone \"%1\"").with(any.name);
        if (a == nullptr) return tell.added(any.name, who, around(any.outline));
        if (b == nullptr) return tell.removed(any.name, who, around(any.outline));
        zones(*a, *b, tell);
      });
  match(
      before.routes, after.routes, [](const Route& r) { return std::string_view{r.name}; },
      [tell = Teller{changes, Subject::Route}](const Route* a, const Route* b) mutable {
        const Route& any = a != nullptr ? *a : *b;
        const Sentence who = phrase("Core", "Route \"%1\"").with(any.name);
        if (a == nullptr) return tell.added(any.name, who, around(any.vertices));
        if (b == nullptr) return tell.removed(any.name, who, around(any.vertices));
        routes(*a, *b, tell);
      });
  match(
      before.vehicles, after.vehicles, [](const VehicleSetup& v) { return v.id; },
      [tell = Teller{changes, Subject::Vehicle}](const VehicleSetup* a, const VehicleSetup* b) mutable {
        const VehicleSetup& any = a != nullptr ? *a : *b;
        const Sentence who = phrase("Core", "Vehicle \"%1\"").with(any.name);
        if (a == nullptr) return tell.added(std::to_string(any.id.value), who, {});
        if (b == nullptr) return tell.removed(std::to_string(any.id.value), who, {});
        vehicles(*a, *b, tell);
      });
  backdrops(before.backdrop, after.backdrop, changes);
  return changes;
}

}  // namespace tessera::sitediff
