// Finds the boxes near a place among very many: a packed R-tree (sort-tile-recursive: Leutenegger et al., ICDE 1997).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/box.h"

namespace tessera::region {

class BoxTree {
public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Calls visit(index) for each box that meets `place`, edges included, in no order that means anything.
  template <class Visit>
  void forEachIn(const Box& place, Visit&& visit) const {
    if (!levels_.empty()) descend(levels_.size() - 1, 0, place, visit);
  }

private:
  static constexpr std::size_t kFanOut = 16;

  template <class Visit>
  void descend(std::size_t level, std::size_t node, const Box& place, Visit&& visit) const {
    const std::vector<Box>& boxes = levels_[level];
    const std::size_t end = std::min(boxes.size(), (node + 1) * kFanOut);
    for (std::size_t i = node * kFanOut; i < end; ++i) {
      if (!meet(boxes[i], place)) continue;
      if (level == 0)
        visit(static_cast<std::size_t>(order_[i]));
      else
        descend(level - 1, i, place, visit);
    }
  }

  std::vector<std::uint32_t> order_;      ///< index of the box at each place of the lowest level
  std::vector<std::vector<Box>> levels_;  ///< a box of level n + 1 holds kFanOut of level n
};

}  // namespace tessera::region
