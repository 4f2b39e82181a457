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

std::vector<floor::TagUid> RegisterEdits::with(const scan::PlaceName& place, const floor::TagUid& uid) const {
  const floor::Tile* tile = tileOf(document_.site(), place.serial);
  auto uids = tile != nullptr ? tile->uids : std::vector<floor::TagUid>{};
  if (uids.size() <= place.tag) uids.resize(place.tag + 1);
  uids[place.tag] = uid;
  while (!uids.empty() && uids.back().empty()) uids.pop_back();
  return uids;
}

Result<void> RegisterEdits::put(const scan::PlaceName& place, const floor::TagUid& uid) {
  const QString serial = QString::fromStdString(place.serial);
  return set(tr("Register tag %1 of tile %2").arg(QString::number(place.tag + 1), serial), place.serial,
             with(place, uid));
}

Result<void> RegisterEdits::takeBack(const scan::PlaceName& place, const floor::TagUid& before) {
  const QString serial = QString::fromStdString(place.serial);
  return set(tr("Take back tag %1 of tile %2").arg(QString::number(place.tag + 1), serial), place.serial,
             with(place, before));
}

Result<void> RegisterEdits::clear(const QString& serial) {
  return set(tr("Clear the registration of tile %1").arg(serial), serial.toStdString(), {});
}

}  // namespace tessera::ui
