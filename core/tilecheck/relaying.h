// Tiles laid otherwise than they are: what an edit of the site would say.
#pragma once

#include <vector>

#include "floor/site.h"

namespace tessera::tilecheck {

/// Each tile's placement as it is and as it is to be. Tiles that change places stand in one together.
struct Relaying {
  struct Move {
    floor::Placement before;
    floor::Placement after;
    bool operator==(const Move&) const = default;
  };
  std::vector<Move> moves;
  bool operator==(const Relaying&) const = default;
};

/// All of it or nothing. False: a tile no longer lies as it did when this was found; nothing has changed then.
[[nodiscard]] bool relay(const Relaying& relaying, floor::Site& site);

/// The placement of a tile of this type that covers the floor from `low` on, turned so.
[[nodiscard]] floor::Placement placedAt(const std::string& serial, const floor::TileType& type, Point low,
                                        int quarterTurns);

}  // namespace tessera::tilecheck
