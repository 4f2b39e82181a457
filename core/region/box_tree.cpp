#include "region/box_tree.h"

#include <cmath>
#include <numeric>

namespace tessera::region {

BoxTree::BoxTree(const std::vector<Box>& boxes) {
  if (boxes.empty()) return;
  std::vector<Point> middles;
  middles.reserve(boxes.size());
  for (const Box& box : boxes) {
    // What is no number would make an order that contradicts itself.
    const Point m = middleOf(box);
    middles.push_back({std::isnan(m.x.value()) ? Metres{} : m.x, std::isnan(m.y.value()) ? Metres{} : m.y});
  }
  order_.resize(boxes.size());
  std::iota(order_.begin(), order_.end(), 0U);
  // Upright slabs of about as many boxes along y as there are slabs; within each from below.
  const std::size_t leaves = (boxes.size() + kFanOut - 1) / kFanOut;
  const std::size_t slab = kFanOut * static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(leaves))));
  std::sort(order_.begin(), order_.end(), [&](auto a, auto b) { return middles[a].x < middles[b].x; });
  for (std::size_t from = 0; from < order_.size(); from += slab) {
    const auto first = order_.begin() + static_cast<std::ptrdiff_t>(from);
    const auto last = order_.begin() + static_cast<std::ptrdiff_t>(std::min(order_.size(), from + slab));
    std::sort(first, last, [&](auto a, auto b) { return middles[a].y < middles[b].y; });
  }
  std::vector<Box>& lowest = levels_.emplace_back();
  lowest.reserve(order_.size());
  for (const std::uint32_t i : order_) lowest.push_back(boxes[i]);
  while (levels_.back().size() > kFanOut) {
    const std::vector<Box>& below = levels_.back();
    std::vector<Box> above;
    for (std::size_t i = 0; i < below.size(); i += kFanOut) {
      Box around = below[i];
      for (std::size_t k = i + 1; k < std::min(below.size(), i + kFanOut); ++k) around = boxAround(around, below[k]);
      above.push_back(around);
    }
    levels_.push_back(std::move(above));
  }
}

}  // namespace tessera::region
