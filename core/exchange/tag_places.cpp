#include "exchange/tag_places.h"

#include <limits>
#include <string_view>
#include <unordered_map>

namespace tessera::exchange {

TagPlaces::TagPlaces(const floor::Site& site) : site_{site} {
  std::unordered_map<std::string_view, std::size_t> types;
  std::unordered_map<std::string_view, std::size_t> tiles;
  for (std::size_t n = 0; n < site.tileTypes.size(); ++n) {
    types.try_emplace(site.tileTypes[n].name, n);
    offsets_.push_back(tagOffsets(site.tileTypes[n]));
  }
  for (std::size_t n = 0; n < site.tiles.size(); ++n) tiles.try_emplace(site.tiles[n].serial, n);
  std::vector<Box> boxes;
  for (const floor::Placement& placement : site.placements) {
    const auto tile = tiles.find(placement.serial);
    const auto type = tile == tiles.end() ? types.end() : types.find(site.tiles[tile->second].type);
    if (type == types.end()) continue;
    laid_.push_back({&placement, tile->second, type->second});
    boxes.push_back(boxOf(placement, site.tileTypes[type->second]));
  }
  tree_ = region::BoxTree{boxes};
}

std::optional<TileTag> TagPlaces::at(Point place, Metres reach, const floor::TagUid& uid) const {
  std::optional<TileTag> found;
  double nearest = std::numeric_limits<double>::infinity();
  tree_.forEachIn(grown({place, place}, reach), [&](std::size_t index) {
    const Laid& laid = laid_[index];
    const auto& uids = site_.tiles[laid.tile].uids;
    for (std::size_t n = 0; n < offsets_[laid.type].size(); ++n) {
      const Metres away = distance(placeOn(*laid.placement, offsets_[laid.type][n]), place);
      if (away > reach) continue;
      const double far = n < uids.size() && uids[n] == uid ? -1.0 : away.value();
      if (far >= nearest) continue;
      nearest = far;
      found = TileTag{laid.tile, n};
    }
  });
  return found;
}

}  // namespace tessera::exchange
