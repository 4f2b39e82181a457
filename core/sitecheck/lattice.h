// Which neighbouring tiles fit, which do not, and which lie upon one another: remembered from edit to edit.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sitecheck/floor_plan.h"
#include "sitecheck/options.h"

namespace tessera::sitecheck {

class Lattice {
public:
  /// Indices into FloorPlan::laid(), a before b.
  struct Misfit {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    Offset off;  ///< b, moved by this, lies on a's lattice
  };

  Lattice() = default;
  Lattice(const FloorPlan& plan, const CheckOptions& options);
  /// `plan` has followed the change already.
  void follow(const FloorPlan& plan, const CheckOptions& options, const FloorChange& change);

  /// Both in the order of the tiles.
  [[nodiscard]] const std::vector<std::pair<std::uint32_t, std::uint32_t>>& overlaps() const { return overlaps_; }
  [[nodiscard]] const std::vector<Misfit>& misfits() const { return misfits_; }
  /// How many neighbours of a laid tile lie as they should.
  [[nodiscard]] std::uint16_t fitsOf(std::uint32_t laid) const { return fits_[laid]; }

private:
  void compare(const FloorPlan& plan, const CheckOptions& options, std::uint32_t a, std::uint32_t b);
  void sort();

  std::vector<std::uint16_t> fits_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> overlaps_;
  std::vector<Misfit> misfits_;
};

}  // namespace tessera::sitecheck
