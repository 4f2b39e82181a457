// Every registered tag of a floor with its place, found by UID in constant time and by place through a grid. Immutable:
// sites that differ in their routes only share one.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/pose.h"
#include "base/result.h"
#include "floor/tag.h"

namespace tessera::floor {

struct PlacedTag {
  TagUid uid;
  Point place;
};

class TagTable {
public:
  /// Error: a UID at two places, or more tags than can be numbered.
  [[nodiscard]] static Result<std::shared_ptr<const TagTable>> build(std::vector<PlacedTag> tags);

  /// The table without the tags of some UIDs and with some more, in the time of a copy. Null: it has to be built, as a
  /// UID is not here or would be at two places, a new place lies outside the grid, or the table would be too full.
  [[nodiscard]] std::shared_ptr<const TagTable> changed(std::span<const TagUid> removed,
                                                        std::span<const PlacedTag> added) const;

  /// Ordered by grid cell, row by row from the lower left.
  [[nodiscard]] const std::vector<PlacedTag>& tags() const { return tags_; }
  [[nodiscard]] std::optional<Point> find(const TagUid& uid) const;
  /// Calls visit(const PlacedTag&) for every tag within `radius` of `centre`, in the order of tags().
  template <class Visit>
  void forEachNear(Point centre, Metres radius, Visit&& visit) const;

private:
  // By itself in half a cache line: a look-up of a tag among a million waits for memory once, and not once more for the
  // place. Empty: no UID.
  struct alignas(32) Slot {
    TagUid uid;
    Point place;
  };

  TagTable() = default;
  void sortIntoGrid(std::vector<PlacedTag> tags);
  [[nodiscard]] Result<void> hashTags();
  /// Where this UID stands in table_ or would have to; nothing: too far from where it belongs.
  [[nodiscard]] std::optional<std::size_t> freeSlot(const TagUid& uid) const;
  void takeOut(std::size_t slot);
  /// Where a tag of this table stands in tags_.
  [[nodiscard]] std::size_t indexOf(const PlacedTag& tag) const;
  [[nodiscard]] std::size_t cellOf(const PlacedTag& tag) const {
    return row(tag.place.y.value()) * grid_.columns + column(tag.place.x.value());
  }
  [[nodiscard]] bool isInGrid(Point place) const {
    const double right = grid_.left + static_cast<double>(grid_.columns) * grid_.cellSize;
    const double top = grid_.bottom + static_cast<double>(grid_.rows) * grid_.cellSize;
    return place.x.value() >= grid_.left && place.x.value() < right && place.y.value() >= grid_.bottom &&
           place.y.value() < top;
  }
  [[nodiscard]] std::size_t column(double x) const { return cell((x - grid_.left) / grid_.cellSize, grid_.columns); }
  [[nodiscard]] std::size_t row(double y) const { return cell((y - grid_.bottom) / grid_.cellSize, grid_.rows); }
  // Whatever lies outside the grid, or is no number, counts to its edge.
  [[nodiscard]] static std::size_t cell(double at, std::size_t count) {
    if (!(at > 0.0)) return 0;
    return at >= static_cast<double>(count) ? count - 1 : static_cast<std::size_t>(at);
  }

  std::vector<PlacedTag> tags_;
  // Grid: the tags of cell c are tags_[cellStart_[c]] up to tags_[cellStart_[c + 1]]; the cells of a row follow one
  // another, so that a stretch of a row is one run of tags.
  struct Grid {
    double left = 0.0;
    double bottom = 0.0;
    double cellSize = 1.0;
    std::size_t columns = 1;
    std::size_t rows = 1;
  };
  Grid grid_;
  std::vector<std::uint32_t> cellStart_;
  // Open addressing with linear probing, at most half full.
  std::vector<Slot> table_;
  std::uint64_t salt_ = 0;
};

template <class Visit>
void TagTable::forEachNear(Point centre, Metres radius, Visit&& visit) const {
  const double x = centre.x.value();
  const double y = centre.y.value();
  const double r = radius.value();
  if (tags_.empty() || !(r >= 0.0)) return;
  // A hair wider than r: a tag on a cell's edge at just that distance must not be lost to rounding.
  const double reach = r + 1e-9 * (1.0 + r + std::abs(x) + std::abs(y));
  const std::size_t firstColumn = column(x - reach);
  const std::size_t lastColumn = column(x + reach);
  const std::size_t lastRow = row(y + reach);
  for (std::size_t at = row(y - reach); at <= lastRow; ++at) {
    const std::size_t end = cellStart_[at * grid_.columns + lastColumn + 1];
    for (std::size_t i = cellStart_[at * grid_.columns + firstColumn]; i < end; ++i) {
      const PlacedTag& tag = tags_[i];
      if (std::hypot(tag.place.x.value() - x, tag.place.y.value() - y) <= r) visit(tag);
    }
  }
}

}  // namespace tessera::floor
