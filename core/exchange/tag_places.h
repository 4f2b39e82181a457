// The tags of laid tiles by where they lie. For this folder's sources.
#pragma once

#include <optional>
#include <vector>

#include "floor/laid_tile.h"
#include "region/box_tree.h"

namespace tessera::exchange {

/// A tag of a tile: its number there, from 0, whether it is registered or not.
struct TileTag {
  std::size_t tile = 0;  ///< in the site's list
  std::size_t tag = 0;
};

class TagPlaces {
public:
  /// Tiles and types that the site does not have are passed over. `site` has to outlive it; its UIDs may change.
  explicit TagPlaces(const floor::Site& site);

  /// The tag that has this UID of those no farther from `place` than `reach`, else the nearest.
  [[nodiscard]] std::optional<TileTag> at(Point place, Metres reach, const floor::TagUid& uid) const;
  /// Calls visit(uid, place) for each registered tag of a laid tile, as they are laid.
  template <class Visit>
  void forEachRegistered(Visit&& visit) const {
    for (const Laid& laid : laid_) {
      const auto& uids = site_.tiles[laid.tile].uids;
      for (std::size_t n = 0; n < std::min(uids.size(), offsets_[laid.type].size()); ++n)
        if (!uids[n].empty()) visit(uids[n], placeOn(*laid.placement, offsets_[laid.type][n]));
    }
  }

private:
  struct Laid {
    const floor::Placement* placement;
    std::size_t tile;
    std::size_t type;
  };
  const floor::Site& site_;
  std::vector<Laid> laid_;
  std::vector<std::vector<Offset>> offsets_;  ///< of each type
  region::BoxTree tree_;                      ///< finds indices into laid_
};

}  // namespace tessera::exchange
