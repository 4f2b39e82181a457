// Finds tiles by their serial numbers while a whole floor is gone through. Floors list their placements in the order of
// their tiles for the most part, so that a look at the same index saves the table of a hundred thousand names.
#pragma once

#include <cstddef>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "floor/site.h"

namespace tessera::floor {

class TileFinder {
public:
  /// `tiles` has to stay as it is.
  explicit TileFinder(const std::vector<Tile>& tiles) : tiles_{tiles} {}

  /// The tile of that serial number, looked for at `guess` first; null: there is none.
  [[nodiscard]] const Tile* find(std::string_view serial, std::size_t guess) {
    if (guess < tiles_.size() && tiles_[guess].serial == serial) return &tiles_[guess];
    if (bySerial_.empty()) {
      bySerial_.reserve(tiles_.size());
      for (const Tile& tile : tiles_) bySerial_.emplace(tile.serial, &tile);
    }
    const auto found = bySerial_.find(serial);
    return found == bySerial_.end() ? nullptr : found->second;
  }

private:
  const std::vector<Tile>& tiles_;
  std::unordered_map<std::string_view, const Tile*> bySerial_;
};

/// Finds the tile types of placements.
class LaidTypes {
public:
  /// `site` has to stay as it is.
  explicit LaidTypes(const Site& site) : tiles_{site.tiles} {
    for (const TileType& type : site.tileTypes) types_.emplace(type.name, &type);
  }

  /// The type of the tile that lies there, looked for at `guess` first; null: the site has none of that serial number,
  /// or not its type.
  [[nodiscard]] const TileType* find(const Placement& placement, std::size_t guess) {
    const Tile* tile = tiles_.find(placement.serial, guess);
    if (tile == nullptr) return nullptr;
    const auto found = types_.find(tile->type);
    return found == types_.end() ? nullptr : found->second;
  }

private:
  TileFinder tiles_;
  std::unordered_map<std::string_view, const TileType*> types_;
};

}  // namespace tessera::floor
