#include "sitecheck/floor_plan.h"

#include <algorithm>
#include <cmath>

#include "floor/laid_tile.h"

namespace tessera::sitecheck {
namespace {

constexpr double kBlock = 8.0;  // metres: some two hundred tiles

// The box that a region is, if it is one.
std::optional<Box> asBox(const region::Region& area) {
  if (area.rings().size() != 1 || area.rings().front().size() != 4) return std::nullopt;
  const Box box = area.bounds();
  return area == region::Region::of(box) || area.squareMetres() == region::Region::of(box).squareMetres()
             ? std::optional{box}
             : std::nullopt;
}

}  // namespace

bool isPlace(const Box& box) {
  constexpr Metres farthest{1e6};
  // Not a number fails every comparison.
  return box.low.x >= -farthest && box.low.y >= -farthest && box.high.x <= farthest && box.high.y <= farthest;
}

FloorPlan::FloorPlan(const floor::Site& site, Metres seam) : seam_{seam}, serials_{site.tiles} {
  offsets_.reserve(site.tileTypes.size());
  for (const floor::TileType& type : site.tileTypes) offsets_.push_back(tagOffsets(type));
  typeOfTile_.reserve(site.tiles.size());
  for (const floor::Tile& tile : site.tiles) {
    const bool asBefore = !typeOfTile_.empty() && tile.type == site.tiles[typeOfTile_.size() - 1].type;
    typeOfTile_.push_back(asBefore ? typeOfTile_.back() : typeNamed(site, tile.type));
  }
  laid_.reserve(site.placements.size());
  tileOfPlacement_.reserve(site.placements.size());
  for (std::uint32_t i = 0; i < site.placements.size(); ++i) {
    const std::uint32_t tile = serials_.find(site.tiles, site.placements[i].serial);
    tileOfPlacement_.push_back(tile);
    anyUnknown_ = anyUnknown_ || tile == kNone;
    if (const auto laid = lay(site, i, tile)) laid_.push_back(*laid);
  }
  noteLaid(site.tiles.size());
  std::vector<Box> boxes;
  boxes.reserve(laid_.size());
  for (const LaidTile& laid : laid_) boxes.push_back(laid.box);
  finder_ = region::BoxFinder{boxes};
  Block* block = nullptr;
  BlockAt last{};
  for (std::uint32_t i = 0; i < laid_.size(); ++i) {
    const BlockAt at = blockAt(laid_[i].box);
    if (block == nullptr || at != last) block = &blocks_[last = at];
    block->laid.push_back(i);
  }
  cover();
}

std::uint32_t FloorPlan::typeNamed(const floor::Site& site, const std::string& name) const {
  const auto found = std::find_if(site.tileTypes.begin(), site.tileTypes.end(),
                                  [&](const floor::TileType& type) { return type.name == name; });
  return found == site.tileTypes.end() ? kNone : static_cast<std::uint32_t>(found - site.tileTypes.begin());
}

std::optional<LaidTile> FloorPlan::lay(const floor::Site& site, std::uint32_t placement, std::uint32_t tile) const {
  if (tile == kNone || typeOfTile_[tile] == kNone) return std::nullopt;
  const std::uint32_t type = typeOfTile_[tile];
  const LaidTile laid{placement, tile, type, boxOf(site.placements[placement], site.tileTypes[type])};
  return isPlace(laid.box) ? std::optional{laid} : std::nullopt;
}

// Of a tile that is laid twice the first counts.
void FloorPlan::noteLaid(std::size_t tiles) {
  laidOfTile_.assign(tiles, kNone);
  for (std::uint32_t i = 0; i < laid_.size(); ++i)
    if (std::uint32_t& at = laidOfTile_[laid_[i].tile]; at == kNone) at = i;
}

Point FloorPlan::placeOf(const floor::Site& site, const LaidTile& laid, std::size_t tag) const {
  return floor::placeOn(site.placements[laid.placement], offsets_[laid.type][tag]);
}

FloorPlan::BlockAt FloorPlan::blockAt(const Box& box) const {
  return {static_cast<std::int64_t>(std::floor(box.low.x.value() / kBlock)),
          static_cast<std::int64_t>(std::floor(box.low.y.value() / kBlock))};
}

// Seams close, so that a floor laid by hand is one area and not a lattice of slits. Blocks that are whole make large
// rectangles at once; only what is left of them is put together by its edges.
void FloorPlan::cover() {
  std::vector<Box> whole;
  std::vector<region::Region> ragged;
  for (auto& [at, block] : blocks_) {
    if (std::exchange(block.isStale, false)) {
      std::sort(block.laid.begin(), block.laid.end());
      std::vector<Box> boxes;
      boxes.reserve(block.laid.size());
      for (const std::uint32_t i : block.laid) boxes.push_back(widened(laid_[i].box));
      block.area = region::Region::unionOf(boxes);
    }
    if (const auto box = asBox(block.area))
      whole.push_back(*box);
    else
      ragged.push_back(block.area);
  }
  region::Region wholes = region::Region::unionOf(whole);
  if (ragged.empty()) {
    covered_ = std::move(wholes);
    return;
  }
  ragged.push_back(std::move(wholes));
  covered_ = region::Region::unionOf(ragged);
}

}  // namespace tessera::sitecheck
