// How the plan of a floor goes along with an edit of some tiles. What it holds of each tile is put in its new order in
// a pass over whole numbers; names are looked up, and areas joined, only for tiles that are new.
#include <algorithm>

#include "sitecheck/floor_plan.h"

namespace tessera::sitecheck {

using floor::Placement;
using floor::Site;
using floor::Tile;

std::optional<FloorChange> FloorPlan::follow(const Site& before, const Site& now) {
  auto tiles = aligned(before.tiles, now.tiles,
                       [](const Tile& a, const Tile& b) { return a.serial == b.serial && a.type == b.type; });
  const auto placements =
      aligned(before.placements, now.placements, [](const Placement& a, const Placement& b) { return a == b; });
  // A new tile could be the one that a placement was waiting for, and of twins the first one counts.
  if (!tiles || !placements || !twins().empty() || (anyUnknown_ && !tiles->fresh.empty())) return std::nullopt;
  if (!tiles->gone.empty() || !tiles->fresh.empty()) {
    serials_.follow(*tiles, now.tiles);
    if (!twins().empty()) return std::nullopt;
    std::vector<std::uint32_t> types(now.tiles.size());
    for (std::size_t i = 0; i < types.size(); ++i)
      types[i] = tiles->wasAt[i] == kGone ? typeNamed(now, now.tiles[i].type) : typeOfTile_[tiles->wasAt[i]];
    typeOfTile_ = std::move(types);
  }
  std::vector<std::uint32_t> laidBefore(before.placements.size(), kNone);
  for (std::uint32_t i = 0; i < laid_.size(); ++i) laidBefore[laid_[i].placement] = i;
  FloorChange change{std::move(*tiles), {}, {}, {}};
  change.laid.nowAt.assign(laid_.size(), kGone);
  std::vector<std::uint32_t> tileOf(now.placements.size(), kNone);
  std::vector<LaidTile> laid;
  laid.reserve(laid_.size() + placements->fresh.size());
  for (std::uint32_t i = 0; i < now.placements.size(); ++i) {
    const std::uint32_t was = placements->wasAt[i];
    if (was == kGone) {
      tileOf[i] = serials_.find(now.tiles, now.placements[i].serial);
      anyUnknown_ = anyUnknown_ || tileOf[i] == kNone;
      const auto added = lay(now, i, tileOf[i]);
      if (!added) continue;
      change.laid.fresh.push_back(static_cast<std::uint32_t>(laid.size()));
      change.laid.wasAt.push_back(kGone);
      change.places.push_back(added->box);
      laid.push_back(*added);
      continue;
    }
    if (const std::uint32_t tile = tileOfPlacement_[was]; tile != kNone) {
      tileOf[i] = change.tiles.nowAt[tile];
      if (tileOf[i] == kGone) return std::nullopt;  // it is laid still, and no longer known
    }
    if (laidBefore[was] == kNone) continue;
    change.laid.nowAt[laidBefore[was]] = static_cast<std::uint32_t>(laid.size());
    change.laid.wasAt.push_back(laidBefore[was]);
    const LaidTile& same = laid_[laidBefore[was]];
    laid.push_back({i, tileOf[i], same.type, same.box});
  }
  for (std::uint32_t i = 0; i < laid_.size(); ++i) {
    if (change.laid.nowAt[i] != kGone) continue;
    change.laid.gone.push_back(i);
    change.goneBoxes.push_back(laid_[i].box);
    change.places.push_back(laid_[i].box);
  }
  laid_ = std::move(laid);
  tileOfPlacement_ = std::move(tileOf);
  noteLaid(now.tiles.size());
  finder_.follow(change.laid.nowAt, change.laid.fresh, laid_.size(), [this](std::uint32_t i) { return laid_[i].box; });
  followBlocks(change);
  return change;
}

void FloorPlan::followBlocks(const FloorChange& change) {
  for (const Box& box : change.goneBoxes) blocks_[blockAt(box)].isStale = true;
  for (auto& [at, block] : blocks_) {
    for (std::uint32_t& i : block.laid) i = change.laid.nowAt[i];
    if (block.isStale) std::erase(block.laid, kGone);
  }
  for (const std::uint32_t i : change.laid.fresh) {
    Block& block = blocks_[blockAt(laid_[i].box)];
    block.laid.push_back(i);
    block.isStale = true;
  }
  std::erase_if(blocks_, [](const auto& entry) { return entry.second.laid.empty(); });
  cover();
}

}  // namespace tessera::sitecheck
