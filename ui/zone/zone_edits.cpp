#include "ui/zone/zone_edits.h"

#include <algorithm>

#include "ui/zone/zone_shape.h"
#include "ui/zone/zone_words.h"

namespace tessera::ui {
namespace {

template <class Zones>
auto zoneCalled(Zones& zones, const std::string& name) {
  return std::find_if(zones.begin(), zones.end(), [&](const floor::Zone& z) { return z.name == name; });
}

tl::unexpected<Error> noZone(const QString& sentence) { return failure(sentence.toStdString()); }

void fitToKind(floor::Zone& zone) {
  if (zone.kind != floor::ZoneKind::Slow) zone.speed.reset();
  if (zone.kind != floor::ZoneKind::OneWay) zone.direction.reset();
  if (zone.kind == floor::ZoneKind::Slow && !zone.speed) zone.speed = ZoneEdits::kUsualSpeed;
  if (zone.kind == floor::ZoneKind::OneWay && !zone.direction) zone.direction = Radians{};
}

}  // namespace

const floor::Zone* ZoneEdits::find(const QString& name) const {
  if (name.isEmpty()) return nullptr;
  const auto& zones = document_.site().zones;
  const auto found = zoneCalled(zones, name.toStdString());
  return found == zones.end() ? nullptr : &*found;
}

QString ZoneEdits::freeName(const QString& stem) const {
  for (int n = 1;; ++n) {
    if (QString name = QStringLiteral("%1 %2").arg(stem).arg(n); find(name) == nullptr) return name;
  }
}

Result<void> ZoneEdits::change(const QString& step, const QString& zone, const std::function<void(floor::Zone&)>& what,
                               int mergeKey) {
  if (find(zone) == nullptr) return noZone(tr("There is no zone called “%1” any more.").arg(zone));
  return document_.edit(
      step, [&](floor::Site& site) { what(*zoneCalled(site.zones, zone.toStdString())); }, mergeKey);
}

Result<QString> ZoneEdits::add(floor::ZoneKind kind, std::vector<Point> outline) {
  if (outline.size() < 3) return noZone(tr("A zone needs at least three corners."));
  if (squareMetres(outline) <= 0.0) return noZone(tr("This outline encloses no floor."));
  floor::Zone zone{freeName(zoneKindName(kind)).toStdString(), kind, std::move(outline), {}, {}};
  fitToKind(zone);
  QString name = QString::fromStdString(zone.name);
  const auto done = document_.edit(tr("Draw %1").arg(name), [&](floor::Site& site) { site.zones.push_back(zone); });
  if (!done) return tl::unexpected{done.error()};
  return name;
}

Result<QString> ZoneEdits::duplicate(const QString& zone) {
  const floor::Zone* from = find(zone);
  if (from == nullptr) return noZone(tr("There is no zone called “%1” any more.").arg(zone));
  // The name must stay within what a site file holds.
  QString stem = zone;
  while (stem.toUtf8().size() > kLongestName - 30) stem.chop(1);
  QString name;
  for (int n = 1; name.isEmpty() || find(name) != nullptr; ++n)
    name = n == 1 ? tr("%1 (copy)").arg(stem) : tr("%1 (copy %2)").arg(stem, QString::number(n));
  floor::Zone copy = *from;
  copy.name = name.toStdString();
  // A little aside, so that it is seen to be there.
  copy.outline = moved(copy.outline, {Metres{0.3}, Metres{-0.3}});
  const auto done = document_.edit(tr("Duplicate %1").arg(zone), [&](floor::Site& site) {
    site.zones.insert(zoneCalled(site.zones, zone.toStdString()) + 1, copy);
  });
  if (!done) return tl::unexpected{done.error()};
  return name;
}

Result<void> ZoneEdits::remove(const QString& zone) {
  if (find(zone) == nullptr) return {};
  return document_.edit(tr("Delete %1").arg(zone),
                        [&](floor::Site& site) { site.zones.erase(zoneCalled(site.zones, zone.toStdString())); });
}

Result<void> ZoneEdits::rename(const QString& zone, const QString& to) {
  const QString name = to.trimmed();
  if (name == zone) return {};
  if (name.isEmpty()) return noZone(tr("A zone needs a name."));
  if (name.toUtf8().size() > kLongestName) return noZone(tr("This name is too long for a zone."));
  if (find(name) != nullptr) return noZone(tr("There is a zone called “%1” already.").arg(name));
  return change(tr("Rename %1").arg(zone), zone, [&](floor::Zone& z) { z.name = name.toStdString(); });
}

Result<void> ZoneEdits::setKind(const QString& zone, floor::ZoneKind kind) {
  return change(tr("Make %1 a %2").arg(zone, zoneKindName(kind)), zone, [&](floor::Zone& z) {
    z.kind = kind;
    fitToKind(z);
  });
}

Result<void> ZoneEdits::setSpeed(const QString& zone, MetresPerSecond speed, int mergeKey) {
  return change(
      tr("Set speed of %1").arg(zone), zone,
      [&](floor::Zone& z) { z.speed = std::clamp(speed, kLeastSpeed, kMostSpeed); }, mergeKey);
}

Result<void> ZoneEdits::setDirection(const QString& zone, Radians direction, int mergeKey) {
  return change(
      tr("Set direction of %1").arg(zone), zone, [&](floor::Zone& z) { z.direction = direction; }, mergeKey);
}

Result<void> ZoneEdits::moveCorner(const QString& zone, std::size_t corner, Point to, int mergeKey) {
  return change(
      tr("Move corner %1 of %2").arg(corner + 1).arg(zone), zone,
      [&](floor::Zone& z) {
        if (corner < z.outline.size()) z.outline[corner] = to;
      },
      mergeKey);
}

Result<void> ZoneEdits::move(const QString& zone, Offset by, int mergeKey) {
  return change(
      tr("Move %1").arg(zone), zone, [&](floor::Zone& z) { z.outline = moved(z.outline, by); }, mergeKey);
}

Result<void> ZoneEdits::insertCorner(const QString& zone, std::size_t before, Point place) {
  const floor::Zone* z = find(zone);
  if (z != nullptr && z->outline.size() >= kMostCorners)
    return noZone(tr("This zone has as many corners as a zone may have."));
  return change(tr("Insert corner into %1").arg(zone), zone, [&](floor::Zone& to) {
    const auto at = static_cast<std::ptrdiff_t>(std::min(before, to.outline.size()));
    to.outline.insert(to.outline.begin() + at, place);
  });
}

Result<void> ZoneEdits::removeCorner(const QString& zone, std::size_t corner) {
  const floor::Zone* z = find(zone);
  if (z != nullptr && z->outline.size() <= 3)
    return noZone(tr("A zone needs three corners; to remove it, delete the zone."));
  return change(tr("Delete corner %1 of %2").arg(corner + 1).arg(zone), zone, [&](floor::Zone& from) {
    if (corner < from.outline.size()) from.outline.erase(from.outline.begin() + static_cast<std::ptrdiff_t>(corner));
  });
}

}  // namespace tessera::ui
