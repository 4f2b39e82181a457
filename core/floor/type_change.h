// What a change of a tile type does to the tiles of that type and to the UIDs that are registered on them.
#pragma once

#include <cstddef>
#include <string>

#include "base/result.h"
#include "floor/site.h"

namespace tessera::floor {

/// Error: what a site file could not hold, e.g. places beyond the tile's edge; the sentence says it.
[[nodiscard]] Result<void> checkTileType(const TileType& type);

/// Columns and rows as many as the pitch lets on the tile, the same distance from opposite edges.
[[nodiscard]] TileType withPlacesFitted(TileType type);

struct TypeUse {
  std::size_t tiles = 0;
  std::size_t registered = 0;  ///< tags on them
};
[[nodiscard]] TypeUse useOf(const Site& site, const std::string& type);

/// A UID stays with its place of the lattice (column, row), as long as the changed type has a tag there.
struct TypeChange {
  std::size_t tiles = 0;
  std::size_t kept = 0;
  std::size_t dropped = 0;
};
[[nodiscard]] TypeChange foresee(const Site& site, const std::string& type, const TileType& to);
/// The lower left corner of the floor that each tile covers stays. A new name goes to the tiles as well.
TypeChange changeTileType(Site& site, const std::string& type, const TileType& to);

}  // namespace tessera::floor
