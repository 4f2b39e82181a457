// The order in which a person with a reader visits the places of a floor's tags.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "floor/site.h"

namespace tessera::scan {

enum class WalkOrder {
  TilesAlongFloor,  ///< tile by tile in rows, each second row the other way; tag by tag within the tile likewise
  TilesByNumber,    ///< in the order of the site's list, those not laid yet included, as at a bench
  RowsOfTags,       ///< rows of tags across all tiles
};

/// A place by name: it outlives edits of the tiles.
struct PlaceName {
  std::string serial;
  std::size_t tag = 0;  ///< in the order of the tile's UIDs, from 0
  bool operator==(const PlaceName&) const = default;
};

struct Stop {
  std::uint32_t tile = 0;  ///< in the site's tiles
  std::uint32_t tag = 0;
  std::optional<Point> place;  ///< nullopt: its tile is not laid
  bool operator==(const Stop&) const = default;
};

/// Every place for a tag just once. tile: only the places of this one; empty: all. The same walk for the same site;
/// which tags are registered makes no difference.
[[nodiscard]] std::vector<Stop> walkOver(const floor::Site& site, WalkOrder order, const std::string& tile = {});

/// Whether both sites have the same places, so that a walk over one is one over the other.
[[nodiscard]] bool samePlaces(const floor::Site& a, const floor::Site& b);

[[nodiscard]] inline PlaceName nameOf(const floor::Site& site, const Stop& stop) {
  return {site.tiles[stop.tile].serial, stop.tag};
}
/// Empty: not registered.
[[nodiscard]] inline floor::TagUid uidAt(const floor::Site& site, const Stop& stop) {
  const auto& uids = site.tiles[stop.tile].uids;
  return stop.tag < uids.size() ? uids[stop.tag] : floor::TagUid{};
}

}  // namespace tessera::scan
