// Finds boxes near a place while some of them come, go and move: a tree of how they were once, and the few that have
// changed since, which are looked through one by one. When those are many the tree is made anew.
#pragma once

#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "region/box_tree.h"

namespace tessera::region {

class BoxFinder {
public:
  static constexpr std::uint32_t kGone = std::numeric_limits<std::uint32_t>::max();

  BoxFinder() = default;
  explicit BoxFinder(const std::vector<Box>& boxes);

  /// nowAt: for each box as it was, its index among the boxes as they are, in the same order; kGone: it is gone, or is
  /// another one now. fresh: indices of those that are new or another, ascending. boxOf(index): a box as it is.
  template <class BoxOf>
  void follow(std::span<const std::uint32_t> nowAt, std::span<const std::uint32_t> fresh, std::size_t count,
              const BoxOf& boxOf) {
    remember(nowAt);
    for (const std::uint32_t i : fresh) changed_.emplace_back(boxOf(i), i);
    if (changed_.size() <= kMostChanged) return;
    std::vector<Box> boxes;
    boxes.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) boxes.push_back(boxOf(i));
    *this = BoxFinder{boxes};
  }

  /// Calls visit(index) for each box that meets `place`, edges included, in no order that means anything.
  template <class Visit>
  void forEachIn(const Box& place, Visit&& visit) const {
    tree_.forEachIn(place, [&](std::size_t i) {
      if (nowAt_[i] != kGone) visit(static_cast<std::size_t>(nowAt_[i]));
    });
    for (const auto& [box, index] : changed_)
      if (meet(box, place)) visit(static_cast<std::size_t>(index));
  }

private:
  static constexpr std::size_t kMostChanged = 500;  // as long to look through as a tree is to climb down some times

  void remember(std::span<const std::uint32_t> nowAt);

  BoxTree tree_;
  std::vector<std::uint32_t> nowAt_;  ///< of each box of the tree
  std::vector<std::pair<Box, std::uint32_t>> changed_;
};

}  // namespace tessera::region
