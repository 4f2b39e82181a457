// What becomes of a tile type's pitch where two such tiles lie side by side.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "floor/site.h"

namespace tessera::floor {

struct Seam {
  enum class Fit { Even, Closer, Wider };

  Metres pitch;  ///< from the last places of one tile to the first ones of the next
  Fit fit = Fit::Even;
  /// Tags on both sides that lie closer to each other than any two within the tile, from the lower left corner of the
  /// first tile: there a reader may see two at once.
  std::vector<std::pair<Offset, Offset>> meeting;
  Metres apart;  ///< how far those lie from each other
};

/// The next tile lies to the right, or above.
enum class Side { Right, Above };
[[nodiscard]] Seam seamOf(const TileType& type, Side side);

/// How far the closest two tags of the tile lie apart; nullopt: it has fewer than two.
[[nodiscard]] std::optional<Metres> closestTags(const TileType& type);

}  // namespace tessera::floor
