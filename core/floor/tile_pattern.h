// Which places of a tile type's lattice have a tag.
#pragma once

#include "floor/site.h"

namespace tessera::floor {

/// Columns and rows count from 0, from the lower left corner.
[[nodiscard]] bool hasTag(const TileType& type, int column, int row);

}  // namespace tessera::floor
