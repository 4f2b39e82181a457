// Where a tile is meant to lie: on the lattice of the tiles beside it.
#pragma once

#include <functional>

#include "base/box.h"
#include "ui/canvas/floor_index.h"

namespace tessera::ui {

/// To the whole micrometre: 1.8 and not 1.7999999999999998.
[[nodiscard]] Point toMicrometre(Point p);

[[nodiscard]] inline Offset sizeOf(const Box& box) { return box.high - box.low; }
[[nodiscard]] inline Box boxOf(Point low, Offset size) { return {low, low + size}; }
[[nodiscard]] inline Box boxOf(const SiteBox& box) { return {box.low, box.high}; }
[[nodiscard]] inline SiteBox siteBoxOf(const Box& box) { return {box.low, box.high}; }

/// Whether they share more than `allowed` along both axes.
[[nodiscard]] bool lieUpon(const Box& a, const Box& b, Metres allowed);
/// A new tile may touch others and no more.
inline constexpr Metres kTouching{0.001};

/// The lower left corner nearest to `low` at which a tile of that size continues the rows and columns that the
/// neighbour begins: its own lattice where the sizes are alike, edge to edge and on from there where they are not.
[[nodiscard]] Point besideTile(Point low, Offset size, const Box& neighbour);

using SkipTile = std::function<bool(const FloorIndex::Tile&)>;

/// The same for the nearest tile of the floor; on a floor without tiles for one at the site's origin.
[[nodiscard]] Point snappedTile(const FloorIndex& floor, Offset size, Point low, const SkipTile& skip = {});
/// No tile of the floor lies there.
[[nodiscard]] bool isFree(const FloorIndex& floor, const Box& box, Metres allowed = kTouching,
                          const SkipTile& skip = {});

}  // namespace tessera::ui
