#include "sitecheck/floor_plan.h"

#include <string_view>
#include <unordered_map>

#include "floor/laid_tile.h"

namespace tessera::sitecheck {
namespace {

// Index of each item by its name; of two of one name the first.
template <class Items, class NameOf>
std::unordered_map<std::string_view, std::uint32_t> byName(const Items& items, NameOf nameOf) {
  std::unordered_map<std::string_view, std::uint32_t> index;
  index.reserve(items.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) index.try_emplace(nameOf(items[i]), i);
  return index;
}

std::uint32_t lookUp(const std::unordered_map<std::string_view, std::uint32_t>& index, std::string_view name) {
  const auto found = index.find(name);
  return found == index.end() ? FloorPlan::kNone : found->second;
}

}  // namespace

bool isPlace(const Box& box) {
  constexpr Metres farthest{1e6};
  // Not a number fails every comparison.
  return box.low.x >= -farthest && box.low.y >= -farthest && box.high.x <= farthest && box.high.y <= farthest;
}

FloorPlan::FloorPlan(const floor::Site& site, Metres seam) : laidOfTile_(site.tiles.size(), kNone) {
  const auto types = byName(site.tileTypes, [](const floor::TileType& t) { return std::string_view{t.name}; });
  auto tiles = byName(site.tiles, [](const floor::Tile& t) { return std::string_view{t.serial}; });
  if (tiles.size() != site.tiles.size())
    for (std::uint32_t i = 0; i < site.tiles.size(); ++i)
      if (const std::uint32_t first = tiles[site.tiles[i].serial]; first != i) twins_.emplace_back(first, i);
  offsets_.reserve(site.tileTypes.size());
  for (const floor::TileType& type : site.tileTypes) offsets_.push_back(tagOffsets(type));
  typeOfTile_.reserve(site.tiles.size());
  for (const floor::Tile& tile : site.tiles) typeOfTile_.push_back(lookUp(types, tile.type));
  laid_.reserve(site.placements.size());
  std::vector<Box> boxes;
  boxes.reserve(site.placements.size());
  for (std::uint32_t i = 0; i < site.placements.size(); ++i) {
    const floor::Placement& placement = site.placements[i];
    const std::uint32_t tile = lookUp(tiles, placement.serial);
    if (tile == kNone || typeOfTile_[tile] == kNone) continue;
    const std::uint32_t type = typeOfTile_[tile];
    const Box box = boxOf(placement, site.tileTypes[type]);
    if (!isPlace(box)) continue;
    if (laidOfTile_[tile] == kNone) laidOfTile_[tile] = static_cast<std::uint32_t>(laid_.size());
    laid_.push_back({i, tile, type, box});
    boxes.push_back(box);
  }
  tree_ = region::BoxTree{boxes};
  // Seams close, so that a floor laid by hand is one area and not a lattice of slits.
  for (Box& box : boxes) box = grown(box, 0.5 * seam);
  covered_ = region::Region::unionOf(boxes);
}

Point FloorPlan::placeOf(const floor::Site& site, const LaidTile& laid, std::size_t tag) const {
  return floor::placeOn(site.placements[laid.placement], offsets_[laid.type][tag]);
}

}  // namespace tessera::sitecheck
