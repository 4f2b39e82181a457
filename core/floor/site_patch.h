// The difference of two sites as what has to be put in the place of what: small where little changed, whatever the
// floor's size, and it leads both ways.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "floor/site.h"

namespace tessera::floor {

/// A stretch of a list: `before`, which began at index `at` of the older list, became `after`. A patch's hunks are
/// ordered and do not touch one another.
template <class Item>
struct Hunk {
  std::size_t at = 0;
  std::vector<Item> before;
  std::vector<Item> after;
};

template <class Item>
using ListPatch = std::vector<Hunk<Item>>;

/// An old and a new value; nothing where they are equal.
template <class Value>
using ValuePatch = std::optional<std::pair<Value, Value>>;

class SitePatch {
public:
  /// Linear in the sites' size. Items that were put in, taken out or changed in place are found each by itself; a
  /// mixture of these in one list may give longer stretches, which are right all the same.
  SitePatch(const Site& before, const Site& after);

  [[nodiscard]] bool empty() const { return items() == 0; }
  /// Whether tile types, tiles, placements or loose tags differ, so that a tag may be somewhere else.
  [[nodiscard]] bool movesTags() const;
  /// Tiles, routes and the like that the patch holds, the older and the newer ones: what it costs to keep.
  [[nodiscard]] std::size_t items() const;
  [[nodiscard]] const ListPatch<TileType>& tileTypes() const { return tileTypes_; }
  [[nodiscard]] const ListPatch<Tile>& tiles() const { return tiles_; }
  [[nodiscard]] const ListPatch<Placement>& placements() const { return placements_; }
  [[nodiscard]] const ListPatch<LooseTag>& looseTags() const { return looseTags_; }
  /// Makes the newer site of the older. `site` has to be the one that the patch was made of.
  void apply(Site& site) const;
  /// Makes the older site of the newer.
  void revert(Site& site) const;

private:
  // Calls visit(the patch of a part, the part) for each part of a site.
  template <class Patch, class Part, class Visit>
  static void forEachPart(Patch& patch, Part& site, Visit&& visit);

  ValuePatch<std::string> name_;
  ValuePatch<Radians> northToY_;
  ValuePatch<RadioSetup> radio_;
  ListPatch<TileType> tileTypes_;
  ListPatch<Tile> tiles_;
  ListPatch<Placement> placements_;
  ListPatch<LooseTag> looseTags_;
  ListPatch<Zone> zones_;
  ListPatch<Route> routes_;
  ListPatch<VehicleSetup> vehicles_;
  ValuePatch<std::optional<Backdrop>> backdrop_;
};

}  // namespace tessera::floor
