// Tiles as they lie, derived once for all checks: boxes on the floor and a way to find neighbours. It follows edits
// that touch some tiles.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "floor/site.h"
#include "region/box_finder.h"
#include "region/region.h"
#include "sitecheck/serial_index.h"

namespace tessera::sitecheck {

/// Indices into the site's lists. They hold as long as placements, tile types and the tiles' serial numbers and types
/// stay the same; UIDs may change.
struct LaidTile {
  std::uint32_t placement = 0;
  std::uint32_t tile = 0;
  std::uint32_t type = 0;
  Box box;
};

/// What an edit did to the floor, for those who remember something of each tile.
struct FloorChange {
  Alignment tiles;             ///< of the site's list
  Alignment laid;              ///< of FloorPlan::laid()
  std::vector<Box> goneBoxes;  ///< of the laid ones that are gone
  std::vector<Box> places;     ///< where tiles lay that are gone, and lie that are new
};

class FloorPlan {
public:
  static constexpr std::uint32_t kNone = kGone;

  FloorPlan() = default;
  /// Leaves out what has no place: unknown tiles and types, places that are no numbers. seam: see covered().
  FloorPlan(const floor::Site& site, Metres seam);

  /// Goes from the site that it was made of on to the next one, whose tile types are the same. Nothing: the edit was
  /// too large or too odd for that, and the plan is of no more use.
  [[nodiscard]] std::optional<FloorChange> follow(const floor::Site& before, const floor::Site& now);

  /// In the order of the placements.
  [[nodiscard]] const std::vector<LaidTile>& laid() const { return laid_; }
  /// Index into laid() for a tile of the site, or kNone.
  [[nodiscard]] std::uint32_t laidOf(std::size_t tile) const { return laidOfTile_[tile]; }
  /// Of a tile of the site: index of its type, or kNone.
  [[nodiscard]] std::uint32_t typeOf(std::size_t tile) const { return typeOfTile_[tile]; }
  /// Of a placement: index of the first tile of its serial number, or kNone.
  [[nodiscard]] std::uint32_t tileOf(std::size_t placement) const { return tileOfPlacement_[placement]; }
  /// Tiles of one serial number: indices of the first and of each later one.
  [[nodiscard]] const std::vector<std::pair<std::uint32_t, std::uint32_t>>& twins() const { return serials_.twins(); }
  [[nodiscard]] const std::vector<Offset>& offsetsOf(std::size_t type) const { return offsets_[type]; }
  [[nodiscard]] Point placeOf(const floor::Site& site, const LaidTile& laid, std::size_t tag) const;
  /// Finds indices into laid().
  [[nodiscard]] const region::BoxFinder& finder() const { return finder_; }
  /// All that is covered with tiles, each half a seam wider all around.
  [[nodiscard]] const region::Region& covered() const { return covered_; }

private:
  // Tiles whose lower left corners lie in one square of the floor, and what they cover: an edit concerns few of them.
  struct Block {
    std::vector<std::uint32_t> laid;
    region::Region area;
    bool isStale = true;
  };
  using BlockAt = std::pair<std::int64_t, std::int64_t>;

  [[nodiscard]] std::uint32_t typeNamed(const floor::Site& site, const std::string& name) const;
  [[nodiscard]] std::optional<LaidTile> lay(const floor::Site& site, std::uint32_t placement, std::uint32_t tile) const;
  void noteLaid(std::size_t tiles);
  [[nodiscard]] Box widened(const Box& box) const { return grown(box, 0.5 * seam_); }
  [[nodiscard]] BlockAt blockAt(const Box& box) const;
  void followBlocks(const FloorChange& change);
  void cover();

  Metres seam_;
  SerialIndex serials_;
  std::vector<LaidTile> laid_;
  std::vector<std::uint32_t> laidOfTile_;
  std::vector<std::uint32_t> typeOfTile_;
  std::vector<std::uint32_t> tileOfPlacement_;
  bool anyUnknown_ = false;  ///< a placement of no known tile
  std::vector<std::vector<Offset>> offsets_;
  region::BoxFinder finder_;
  std::map<BlockAt, Block> blocks_;
  region::Region covered_;
};

/// Not farther from the origin than a map allows, and a number.
[[nodiscard]] bool isPlace(const Box& box);

}  // namespace tessera::sitecheck
