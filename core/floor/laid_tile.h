// Where a laid tile and its tags are on the site: P = L + R(turn) * l.
#pragma once

#include "base/box.h"
#include "floor/site.h"

namespace tessera::floor {

/// Quarter turns are exact: no sine of half pi that is almost one.
[[nodiscard]] constexpr Offset quarterTurned(Offset l, int turns) {
  switch (((turns % 4) + 4) % 4) {
    case 1:
      return {-l.y, l.x};
    case 2:
      return {-l.x, -l.y};
    case 3:
      return {l.y, -l.x};
    default:
      return l;
  }
}

/// The place on the site of what lies at `l` from the tile's lower left corner before it was turned.
[[nodiscard]] constexpr Point placeOn(const Placement& placement, Offset l) {
  return placement.origin + quarterTurned(l, placement.quarterTurns);
}

/// The floor that a tile covers.
[[nodiscard]] constexpr Box boxOf(const Placement& placement, const TileType& type) {
  const Point a = placement.origin;
  const Point b = placeOn(placement, {type.width, type.height});
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

/// The placement's origin with which such a tile covers the floor from that lower left corner on.
[[nodiscard]] constexpr Point originFor(Point low, const TileType& type, int turns) {
  const Placement atZero{{}, {}, turns};
  return low - (boxOf(atZero, type).low - Point{});
}

}  // namespace tessera::floor
