// An upright rectangle of the site frame: what is in view, what a floor covers.
#pragma once

#include <algorithm>

#include "base/pose.h"

namespace tessera::ui {

/// Empty until something is added.
struct SiteBox {
  Point low{Metres{1e300}, Metres{1e300}};
  Point high{Metres{-1e300}, Metres{-1e300}};

  [[nodiscard]] bool empty() const { return low.x > high.x || low.y > high.y; }
  [[nodiscard]] Metres width() const { return empty() ? Metres{} : high.x - low.x; }
  [[nodiscard]] Metres height() const { return empty() ? Metres{} : high.y - low.y; }
  [[nodiscard]] Point centre() const { return low + 0.5 * (high - low); }
  [[nodiscard]] bool contains(Point p) const { return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y; }
  [[nodiscard]] bool touches(const SiteBox& o) const {
    return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y;
  }
  void add(Point p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  void add(const SiteBox& o) {
    if (o.empty()) return;
    add(o.low);
    add(o.high);
  }
  [[nodiscard]] SiteBox grown(Metres by) const { return {low - Offset{by, by}, high + Offset{by, by}}; }
};

}  // namespace tessera::ui
