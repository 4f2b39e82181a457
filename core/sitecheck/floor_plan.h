// Tiles as they lie, derived once for all checks: boxes on the floor and a tree to find neighbours.
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "floor/site.h"
#include "region/box_tree.h"
#include "region/region.h"

namespace tessera::sitecheck {

/// Indices into the site's lists. They hold as long as placements, tile types and the tiles' serial numbers and types
/// stay the same; UIDs may change.
struct LaidTile {
  std::uint32_t placement = 0;
  std::uint32_t tile = 0;
  std::uint32_t type = 0;
  Box box;
};

class FloorPlan {
public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  FloorPlan() = default;
  /// Leaves out what has no place: unknown tiles and types, places that are no numbers. seam: see covered().
  FloorPlan(const floor::Site& site, Metres seam);

  [[nodiscard]] const std::vector<LaidTile>& laid() const { return laid_; }
  /// Index into laid() for a tile of the site, or kNone.
  [[nodiscard]] std::uint32_t laidOf(std::size_t tile) const { return laidOfTile_[tile]; }
  /// Of a tile of the site: index of its type, or kNone.
  [[nodiscard]] std::uint32_t typeOf(std::size_t tile) const { return typeOfTile_[tile]; }
  /// Tiles of one serial number: indices of the first and of each later one.
  [[nodiscard]] const std::vector<std::pair<std::uint32_t, std::uint32_t>>& twins() const { return twins_; }
  [[nodiscard]] const std::vector<Offset>& offsetsOf(std::size_t type) const { return offsets_[type]; }
  [[nodiscard]] Point placeOf(const floor::Site& site, const LaidTile& laid, std::size_t tag) const;
  /// Finds indices into laid().
  [[nodiscard]] const region::BoxTree& tree() const { return tree_; }
  /// All that is covered with tiles, each half a seam wider all around.
  [[nodiscard]] const region::Region& covered() const { return covered_; }

private:
  std::vector<LaidTile> laid_;
  std::vector<std::uint32_t> laidOfTile_;
  std::vector<std::uint32_t> typeOfTile_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> twins_;
  std::vector<std::vector<Offset>> offsets_;
  region::BoxTree tree_;
  region::Region covered_;
};

/// Not farther from the origin than a map allows, and a number.
[[nodiscard]] bool isPlace(const Box& box);

}  // namespace tessera::sitecheck
