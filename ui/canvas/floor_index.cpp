#include "ui/canvas/floor_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <unordered_map>

#include "floor/laid_tile.h"
#include "floor/tile_finder.h"

namespace tessera::ui {
FloorIndex::FloorIndex(const floor::Site& site) {
  std::unordered_map<std::string_view, const floor::TileType*> types;
  for (const floor::TileType& type : site.tileTypes) types.emplace(type.name, &type);
  floor::TileFinder known{site.tiles};

  Metres pitch{std::numeric_limits<double>::infinity()};
  Metres smallest = pitch;
  std::map<std::pair<const floor::TileType*, int>, std::uint32_t> shapes;
  tiles_.reserve(site.placements.size());
  serials_.reserve(site.placements.size());
  for (const floor::Placement& placement : site.placements) {
    const floor::Tile* tile = known.find(placement.serial, serials_.size());
    if (tile == nullptr) continue;
    const auto found = types.find(tile->type);
    if (found == types.end()) continue;
    const floor::TileType& type = *found->second;
    const int turns = ((placement.quarterTurns % 4) + 4) % 4;
    const auto [shape, isNew] = shapes.try_emplace({&type, turns}, static_cast<std::uint32_t>(shapes_.size()));
    if (isNew) {
      std::vector<Offset> offsets = floor::tagOffsets(type);
      for (Offset& o : offsets) o = floor::quarterTurned(o, turns);
      shapes_.push_back(std::move(offsets));
      if (type.pitch > Metres{}) pitch = std::min(pitch, type.pitch);
      smallest = std::min({smallest, type.width, type.height});
      largest_ = std::max({largest_, type.width.value(), type.height.value()});
    }
    SiteBox box;
    box.add(placement.origin);
    box.add(floor::placeOn(placement, {type.width, type.height}));
    tiles_.push_back({box, placement.origin, shape->second, static_cast<std::uint32_t>(registered_.size()),
                      static_cast<std::uint32_t>(serials_.size())});
    serials_.push_back(placement.serial);
    const std::vector<floor::TagUid>& uids = tile->uids;
    for (std::size_t n = 0; n < shapes_[shape->second].size(); ++n)
      registered_.push_back(n < uids.size() && !uids[n].empty());
    box_.add(box);
  }
  for (const floor::LooseTag& tag : site.looseTags) {
    loose_.push_back({tag.place});
    box_.add(tag.place);
  }
  if (std::isfinite(pitch.value())) pitch_ = std::max(pitch, Metres{0.005});
  if (std::isfinite(smallest.value())) smallestTile_ = smallest;
  sortIntoCells();
}

void FloorIndex::sortIntoCells() {
  if (tiles_.empty()) {
    cellStart_.assign(2, 0);
    return;
  }
  left_ = box_.low.x.value();
  bottom_ = box_.low.y.value();
  // About one tile a cell, and never many more cells than tiles, however far apart they lie.
  const double area = std::max(box_.width().value(), 1e-3) * std::max(box_.height().value(), 1e-3);
  cellSize_ = std::max({largest_, std::sqrt(area / static_cast<double>(tiles_.size())), 1e-3});
  const double longest = std::max(box_.width().value(), box_.height().value());
  cellSize_ = std::max(cellSize_, longest / static_cast<double>(4 * tiles_.size() + 1));
  columns_ = static_cast<std::size_t>(box_.width().value() / cellSize_) + 1;
  rows_ = static_cast<std::size_t>(box_.height().value() / cellSize_) + 1;
  const auto cellOf = [this](const Tile& t) {
    return row(t.box.low.y.value()) * columns_ + column(t.box.low.x.value());
  };
  std::stable_sort(tiles_.begin(), tiles_.end(), [&](const Tile& a, const Tile& b) { return cellOf(a) < cellOf(b); });
  cellStart_.assign(rows_ * columns_ + 1, 0);
  for (const Tile& tile : tiles_) ++cellStart_[cellOf(tile) + 1];
  for (std::size_t c = 1; c < cellStart_.size(); ++c) cellStart_[c] += cellStart_[c - 1];
}

bool sameFloor(const floor::Site& a, const floor::Site& b) {
  return a.tileTypes == b.tileTypes && a.placements == b.placements && a.looseTags == b.looseTags && a.tiles == b.tiles;
}

}  // namespace tessera::ui
