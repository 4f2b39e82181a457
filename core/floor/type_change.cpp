#include "floor/type_change.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_set>

#include "floor/laid_tile.h"
#include "floor/tile_pattern.h"

namespace tessera::floor {
namespace {

using NewPlaces = std::vector<std::optional<std::size_t>>;

// For each tag of the old type the number of the new type's tag at the same place of the lattice.
NewPlaces placesAfter(const TileType& from, const TileType& to) {
  std::vector<std::optional<std::size_t>> numbers(static_cast<std::size_t>(to.columns) *
                                                  static_cast<std::size_t>(to.rows));
  std::size_t count = 0;
  const auto at = [&to](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(to.columns) + static_cast<std::size_t>(column);
  };
  for (int row = 0; row < to.rows; ++row) {
    for (int column = 0; column < to.columns; ++column)
      if (hasTag(to, column, row)) numbers[at(column, row)] = count++;
  }
  NewPlaces after;
  for (int row = 0; row < from.rows; ++row) {
    for (int column = 0; column < from.columns; ++column) {
      if (!hasTag(from, column, row)) continue;
      after.push_back(column < to.columns && row < to.rows ? numbers[at(column, row)] : std::nullopt);
    }
  }
  return after;
}

const TileType* typeNamed(const Site& site, const std::string& name) {
  const auto found =
      std::find_if(site.tileTypes.begin(), site.tileTypes.end(), [&](const TileType& t) { return t.name == name; });
  return found == site.tileTypes.end() ? nullptr : &*found;
}

void count(const Tile& tile, const NewPlaces& after, TypeChange& change) {
  ++change.tiles;
  for (std::size_t n = 0; n < tile.uids.size(); ++n) {
    if (!tile.uids[n].empty()) ++(n < after.size() && after[n] ? change.kept : change.dropped);
  }
}

std::vector<TagUid> moved(const std::vector<TagUid>& uids, const NewPlaces& after) {
  std::vector<TagUid> to;
  for (std::size_t n = 0; n < uids.size() && n < after.size(); ++n) {
    if (uids[n].empty() || !after[n]) continue;
    if (to.size() <= *after[n]) to.resize(*after[n] + 1);
    to[*after[n]] = uids[n];
  }
  return to;
}

}  // namespace

Result<void> checkTileType(const TileType& type) {
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  if (type.name.empty()) return failure(phrase("Core", "A tile type needs a name."));
  if (type.name.size() > 200) return failure(phrase("Core", "This name is too long for a tile type."));
  if (!within(type.width.value(), 0.01, 100.0) || !within(type.height.value(), 0.01, 100.0))
    return failure(phrase("Core", "A tile is 1 cm to 100 m long and wide."));
  if (!within(type.pitch.value(), 0.001, 100.0))
    return failure(phrase("Core", "The pitch of a tile is 1 mm to 100 m."));
  if (!within(type.columns, 1, 100) || !within(type.rows, 1, 100))
    return failure(phrase("Core", "A tile has 1 to 100 columns and rows of places."));
  constexpr Metres slack{1e-6};
  const bool onTile = type.margin.x >= -slack && type.margin.y >= -slack &&
                      type.margin.x + (type.columns - 1) * type.pitch <= type.width + slack &&
                      type.margin.y + (type.rows - 1) * type.pitch <= type.height + slack;
  if (!onTile) return failure(phrase("Core", "The places reach beyond the edge of the tile."));
  const auto places = static_cast<std::size_t>(type.columns) * static_cast<std::size_t>(type.rows);
  if (type.pattern == Pattern::Custom && type.custom.size() != places)
    return failure(phrase("Core", "The pattern does not have as many places as the tile."));
  if (tagOffsets(type).empty()) return failure(phrase("Core", "The tile type %1 has no tags.").with(type.name));
  return {};
}

TileType withPlacesFitted(TileType type) {
  const auto fitted = [&](Metres length) {
    return std::clamp(static_cast<int>(std::floor(length / type.pitch + 1e-6)), 1, 100);
  };
  const auto margin = [&](Metres length, int places) {
    return Metres{std::round(std::max(0.0, (length - (places - 1) * type.pitch).value() / 2.0) * 1e6) / 1e6};
  };
  const int columns = fitted(type.width);
  const int rows = fitted(type.height);
  if (type.pattern == Pattern::Custom) {
    std::vector<bool> places;
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column)
        places.push_back(column < type.columns && row < type.rows && hasTag(type, column, row));
    }
    type.custom = std::move(places);
  }
  type.columns = columns;
  type.rows = rows;
  type.margin = {margin(type.width, columns), margin(type.height, rows)};
  return type;
}

TypeUse useOf(const Site& site, const std::string& type) {
  TypeUse use;
  for (const Tile& tile : site.tiles) {
    if (tile.type != type) continue;
    ++use.tiles;
    use.registered += static_cast<std::size_t>(
        std::count_if(tile.uids.begin(), tile.uids.end(), [](const TagUid& uid) { return !uid.empty(); }));
  }
  return use;
}

TypeChange foresee(const Site& site, const std::string& type, const TileType& to) {
  TypeChange change;
  const TileType* from = typeNamed(site, type);
  if (from == nullptr) return change;
  const NewPlaces after = placesAfter(*from, to);
  for (const Tile& tile : site.tiles) {
    if (tile.type == type) count(tile, after, change);
  }
  return change;
}

TypeChange changeTileType(Site& site, const std::string& type, const TileType& to) {
  TypeChange change;
  const TileType* known = typeNamed(site, type);
  if (known == nullptr) return change;
  const TileType from = *known;
  const NewPlaces after = placesAfter(from, to);
  const bool samePlaces = tagOffsets(from).size() == tagOffsets(to).size() &&
                          std::all_of(after.begin(), after.end(), [n = 0U](const auto& place) mutable {
                            return place == std::optional<std::size_t>{n++};
                          });
  std::unordered_set<std::string> ofType;
  for (Tile& tile : site.tiles) {
    if (tile.type != type) continue;
    count(tile, after, change);
    if (!samePlaces) tile.uids = moved(tile.uids, after);
    tile.type = to.name;
    ofType.insert(tile.serial);
  }
  for (Placement& placement : site.placements) {
    if ((from.width == to.width && from.height == to.height) || !ofType.contains(placement.serial)) continue;
    const Offset shift = boxOf(placement, from).low - boxOf(placement, to).low;
    placement.origin = placement.origin + shift;
  }
  *std::find_if(site.tileTypes.begin(), site.tileTypes.end(), [&](const TileType& t) { return t.name == type; }) = to;
  return change;
}

}  // namespace tessera::floor
