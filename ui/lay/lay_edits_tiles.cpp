// Tiles that come, go and get another name.
#include <algorithm>
#include <unordered_map>

#include "floor/laid_tile.h"
#include "region/box_tree.h"
#include "ui/lay/lay_edits.h"

namespace tessera::ui {
namespace {

tl::unexpected<Error> sayWhyNot(const QString& text) { return failure(text.toStdString()); }

}  // namespace

Result<TileSet> LayEdits::lay(const QString& step, const std::vector<NewTile>& tiles, const floor::SerialRule& rule,
                              const std::vector<floor::TileType>& types) {
  const floor::Site& site = document_.site();
  if (site.tiles.size() + tiles.size() > kMostTiles) return sayWhyNot(tr("A site holds no more than a million tiles."));
  std::vector<floor::TileType> added;
  std::unordered_map<std::string, floor::TileType> known;
  for (const floor::TileType& t : site.tileTypes) known.emplace(t.name, t);
  for (const floor::TileType& t : types) {
    const auto [at, isNew] = known.emplace(t.name, t);
    if (isNew) added.push_back(t);
    if (at->second != t)
      return sayWhyNot(tr("This site has a tile type “%1” that is another one.").arg(QString::fromStdString(t.name)));
  }
  std::vector<Box> boxes;
  std::vector<floor::Placement> placements;
  for (const NewTile& tile : tiles) {
    const auto found = known.find(tile.type);
    if (found == known.end())
      return sayWhyNot(tr("There is no tile type “%1” any more.").arg(QString::fromStdString(tile.type)));
    placements.push_back(
        {{}, toMicrometre(floor::originFor(tile.low, found->second, tile.quarterTurns)), tile.quarterTurns});
    boxes.push_back(floor::boxOf(placements.back(), found->second));
  }
  const region::BoxTree tree{boxes};
  bool upon = false;
  for (const Laid& old : laid())
    tree.forEachIn(old.box, [&](std::size_t n) { upon = upon || lieUpon(boxes[n], old.box, kTouching); });
  for (std::size_t n = 0; n < boxes.size(); ++n)
    tree.forEachIn(boxes[n], [&](std::size_t m) { upon = upon || (m < n && lieUpon(boxes[n], boxes[m], kTouching)); });
  if (upon) return sayWhyNot(tr("There are tiles already: none may lie upon another."));

  const std::vector<std::string> serials = floor::freeSerials(site, rule, tiles.size());
  const auto done = document_.edit(step, [&](floor::Site& to) {
    to.tileTypes.insert(to.tileTypes.end(), added.begin(), added.end());
    for (std::size_t n = 0; n < tiles.size(); ++n) {
      to.tiles.push_back({serials[n], tiles[n].type, {}});
      placements[n].serial = serials[n];
      to.placements.push_back(placements[n]);
    }
  });
  if (!done) return tl::unexpected{done.error()};
  return TileSet{serials.begin(), serials.end()};
}

Result<void> LayEdits::remove(const TileSet& tiles) {
  if (tiles.empty()) return {};
  return document_.edit(tr("Delete %n tile(s)", nullptr, static_cast<int>(tiles.size())), [&](floor::Site& site) {
    std::erase_if(site.placements, [&](const floor::Placement& p) { return tiles.contains(p.serial); });
    std::erase_if(site.tiles, [&](const floor::Tile& t) { return tiles.contains(t.serial); });
  });
}

Result<void> LayEdits::rename(const std::string& serial, const QString& to) {
  const QString name = to.trimmed();
  const std::string after = name.toStdString();
  if (after == serial) return {};
  if (name.isEmpty()) return sayWhyNot(tr("A tile needs a serial number."));
  if (after.size() > kLongestSerial) return sayWhyNot(tr("This serial number is too long."));
  const auto& tiles = document_.site().tiles;
  if (std::any_of(tiles.begin(), tiles.end(), [&](const floor::Tile& t) { return t.serial == after; }))
    return sayWhyNot(tr("There is a tile “%1” already.").arg(name));
  return document_.edit(tr("Rename tile %1").arg(QString::fromStdString(serial)), [&](floor::Site& site) {
    for (floor::Tile& tile : site.tiles)
      if (tile.serial == serial) tile.serial = after;
    for (floor::Placement& placement : site.placements)
      if (placement.serial == serial) placement.serial = after;
  });
}

}  // namespace tessera::ui
