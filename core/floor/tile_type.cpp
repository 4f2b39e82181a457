// Where a tile type has its tags.
#include "floor/tile_pattern.h"

namespace tessera::floor {

bool hasTag(const TileType& type, int column, int row) {
  switch (type.pattern) {
    case Pattern::Full:
      return true;
    case Pattern::OneInTwo:
      return ((column + row) % 2 == 0) != type.startsWithGap;
    case Pattern::Custom: {
      const auto place =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(type.columns) + static_cast<std::size_t>(column);
      return place < type.custom.size() && type.custom[place];
    }
  }
  return false;
}

std::vector<Offset> tagOffsets(const TileType& type) {
  std::vector<Offset> offsets;
  for (int row = 0; row < type.rows; ++row) {
    for (int column = 0; column < type.columns; ++column) {
      if (hasTag(type, column, row)) offsets.push_back(type.margin + Offset{column * type.pitch, row * type.pitch});
    }
  }
  return offsets;
}

}  // namespace tessera::floor
