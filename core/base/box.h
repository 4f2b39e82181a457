// An upright rectangle in the site frame.
#pragma once

#include <algorithm>
#include <span>

#include "base/pose.h"

namespace tessera {

struct Box {
  Point low;   ///< smallest x and y
  Point high;  ///< greatest x and y
  constexpr bool operator==(const Box&) const = default;
};

/// Requires at least one point.
[[nodiscard]] constexpr Box boxAround(std::span<const Point> points) {
  Box box{points.front(), points.front()};
  for (const Point& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}
[[nodiscard]] constexpr Box boxAround(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}
[[nodiscard]] constexpr Box grown(const Box& b, Metres by) {
  return {{b.low.x - by, b.low.y - by}, {b.high.x + by, b.high.y + by}};
}
[[nodiscard]] constexpr bool meet(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}
[[nodiscard]] constexpr Point middleOf(const Box& b) {
  return {0.5 * (b.low.x + b.high.x), 0.5 * (b.low.y + b.high.y)};
}

}  // namespace tessera
