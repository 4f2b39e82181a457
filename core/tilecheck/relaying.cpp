#include "tilecheck/relaying.h"

#include <algorithm>

#include "floor/laid_tile.h"

namespace tessera::tilecheck {

bool relay(const Relaying& relaying, floor::Site& site) {
  std::vector<floor::Placement*> found;
  for (const Relaying::Move& move : relaying.moves) {
    const auto at = std::find(site.placements.begin(), site.placements.end(), move.before);
    if (at == site.placements.end()) return false;
    found.push_back(&*at);
  }
  for (std::size_t i = 0; i < found.size(); ++i) *found[i] = relaying.moves[i].after;
  return !found.empty();
}

floor::Placement placedAt(const std::string& serial, const floor::TileType& type, Point low, int quarterTurns) {
  const floor::Placement beside{serial, {}, quarterTurns};
  const Point itsLow = floor::boxOf(beside, type).low;
  return {serial, low + (Point{} - itsLow), quarterTurns};
}

}  // namespace tessera::tilecheck
