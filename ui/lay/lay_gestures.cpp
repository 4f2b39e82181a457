#include "ui/lay/lay_gestures.h"

#include <algorithm>
#include <cmath>

#include "floor/laid_tile.h"
#include "floor/tile_finder.h"

namespace tessera::ui {
namespace {

constexpr double kFarthestCell = 1e6;

}  // namespace

const floor::TileType& TileStamp::typeOf(const NewTile& tile) const {
  return *std::find_if(types.begin(), types.end(), [&](const floor::TileType& t) { return t.name == tile.type; });
}

Box TileStamp::boxOf(const NewTile& tile, Point low) const {
  const floor::TileType& type = typeOf(tile);
  const bool across = tile.quarterTurns % 2 != 0;
  return ui::boxOf(low + (tile.low - Point{}),
                   across ? Offset{type.height, type.width} : Offset{type.width, type.height});
}

// (x, y) -> (-y, x), then back to where the corner of all is the lower left one: the upper edge becomes the left one.
void TileStamp::turn() {
  for (NewTile& tile : tiles) {
    const Box box = boxOf(tile, {});
    tile.low = toMicrometre({size.y - box.high.y, box.low.x});
    tile.quarterTurns = (tile.quarterTurns + 1) % 4;
  }
  size = {size.y, size.x};
}

TileStamp stampOf(const floor::Site& site, const TileSet& tiles) {
  floor::LaidTypes types{site};
  TileStamp stamp;
  std::vector<Box> boxes;
  for (std::size_t n = 0; n < site.placements.size(); ++n) {
    const floor::Placement& placement = site.placements[n];
    const floor::TileType* laid = tiles.contains(placement.serial) ? types.find(placement, n) : nullptr;
    if (laid == nullptr) continue;
    const floor::TileType& type = *laid;
    boxes.push_back(floor::boxOf(placement, type));
    stamp.tiles.push_back({type.name, boxes.back().low, placement.quarterTurns});
    const bool known = std::any_of(stamp.types.begin(), stamp.types.end(),
                                   [&](const floor::TileType& t) { return t.name == type.name; });
    if (!known) stamp.types.push_back(type);
  }
  if (boxes.empty()) return stamp;
  Box all = boxes.front();
  for (const Box& box : boxes) all = boxAround(all, box);
  for (NewTile& tile : stamp.tiles) tile.low = toMicrometre(Point{} + (tile.low - all.low));
  stamp.size = sizeOf(all);
  return stamp;
}

LayCell LayLattice::cellAt(Point place) const {
  const auto cell = [](Metres at, Metres from, Metres one) {
    return static_cast<int>(std::clamp(std::floor((at - from) / one), -kFarthestCell, kFarthestCell));
  };
  return {cell(place.x, first.x, size.x), cell(place.y, first.y, size.y)};
}

Box LayLattice::boxOf(LayCell cell) const {
  const Point low = toMicrometre(first + Offset{cell.column * size.x, cell.row * size.y});
  return ui::boxOf(low, size);
}

void LayStroke::goTo(LayCell cell, const FloorIndex& floor) {
  if (!begun_) {
    begun_ = true;
    at_ = cell;
    return visit(cell, floor);
  }
  const int steps = std::max(std::abs(cell.column - at_.column), std::abs(cell.row - at_.row));
  for (int n = 1; n <= steps && n <= LayFill::kMostCells; ++n) {
    const double share = static_cast<double>(n) / steps;
    visit({at_.column + static_cast<int>(std::lround(share * (cell.column - at_.column))),
           at_.row + static_cast<int>(std::lround(share * (cell.row - at_.row)))},
          floor);
  }
  at_ = cell;
}

void LayStroke::visit(LayCell cell, const FloorIndex& floor) {
  const std::uint64_t key = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.column)) << 32U) |
                            static_cast<std::uint32_t>(cell.row);
  if (!seen_.insert(key).second) return;
  const Box box = lattice_.boxOf(cell);
  if (isFree(floor, box)) boxes_.push_back(box);
}

Box LayFill::box() const { return boxAround(lattice.boxOf({}), lattice.boxOf(to)); }

std::vector<Box> LayFill::freeBoxes(const FloorIndex& floor, const Box& within) const {
  std::vector<Box> boxes;
  const LayCell low = lattice.cellAt(within.low);
  const LayCell high = lattice.cellAt(within.high);
  for (int row = std::max(std::min(0, to.row), low.row); row <= std::min(std::max(0, to.row), high.row); ++row) {
    for (int column = std::max(std::min(0, to.column), low.column);
         column <= std::min(std::max(0, to.column), high.column); ++column) {
      const Box box = lattice.boxOf({column, row});
      if (isFree(floor, box)) boxes.push_back(box);
    }
  }
  return boxes;
}

}  // namespace tessera::ui
