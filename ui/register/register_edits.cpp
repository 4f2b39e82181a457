#include "ui/register/register_edits.h"

#include <algorithm>

namespace tessera::ui {

const floor::Tile* tileOf(const floor::Site& site, const std::string& serial) {
  const auto found =
      std::find_if(site.tiles.begin(), site.tiles.end(), [&](const floor::Tile& t) { return t.serial == serial; });
  return found == site.tiles.end() ? nullptr : &*found;
}

Result<void> RegisterEdits::set(const QString& step, const std::string& serial, std::vector<floor::TagUid> uids) {
  if (tileOf(document_.site(), serial) == nullptr)
    return failure(tr("There is no tile %1 any more.").arg(QString::fromStdString(serial)).toStdString());
  return document_.edit(step, [&](floor::Site& site) {
    for (floor::Tile& t : site.tiles)
      if (t.serial == serial) t.uids = std::move(uids);
  });
}

Result<void> RegisterEdits::setAll(const QString& step, const std::vector<scan::Put>& puts) {
  if (puts.empty()) return {};
  const std::string& serial = puts.front().place.serial;
  const floor::Tile* tile = tileOf(document_.site(), serial);
  auto uids = tile != nullptr ? tile->uids : std::vector<floor::TagUid>{};
  for (const scan::Put& put : puts) {
    if (uids.size() <= put.place.tag) uids.resize(put.place.tag + 1);
    uids[put.place.tag] = put.uid;
  }
  while (!uids.empty() && uids.back().empty()) uids.pop_back();
  return set(step, serial, std::move(uids));
}

Result<void> RegisterEdits::put(const scan::PlaceName& place, const floor::TagUid& uid) {
  const QString serial = QString::fromStdString(place.serial);
  return setAll(tr("Register tag %1 of tile %2").arg(QString::number(place.tag + 1), serial), {{place, uid}});
}

Result<void> RegisterEdits::takeBack(const std::vector<scan::Put>& puts) {
  if (puts.empty()) return {};
  const QString serial = QString::fromStdString(puts.front().place.serial);
  return setAll(puts.size() > 1
                    ? tr("Take back the tags of tile %1").arg(serial)
                    : tr("Take back tag %1 of tile %2").arg(QString::number(puts.front().place.tag + 1), serial),
                puts);
}

Result<void> RegisterEdits::exchange(const std::vector<scan::Put>& puts) {
  if (puts.size() != 2) return {};
  return setAll(tr("Exchange tags %1 and %2 of tile %3")
                    .arg(QString::number(puts[0].place.tag + 1), QString::number(puts[1].place.tag + 1),
                         QString::fromStdString(puts[0].place.serial)),
                puts);
}

Result<void> RegisterEdits::readAnew(const std::vector<scan::Put>& puts) {
  if (puts.empty()) return {};
  return setAll(tr("Read tile %1 anew").arg(QString::fromStdString(puts.front().place.serial)), puts);
}

Result<void> RegisterEdits::clear(const QString& serial) {
  return set(tr("Clear the registration of tile %1").arg(serial), serial.toStdString(), {});
}

}  // namespace tessera::ui
