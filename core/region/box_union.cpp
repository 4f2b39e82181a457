// A floor of a hundred thousand tiles is a handful of rectangles once neighbours are put together; Clipper then has
// little left to do.
#include <algorithm>

#include "region/clipper_bridge.h"

namespace tessera::region {
namespace {

struct Rectangle {
  Node low;
  Node high;
};

// Puts rectangles of the same lower and upper edge that touch or overlap along x into one.
void mergeAlongX(std::vector<Rectangle>& all) {
  std::sort(all.begin(), all.end(), [](const Rectangle& a, const Rectangle& b) {
    if (a.low.y != b.low.y) return a.low.y < b.low.y;
    if (a.high.y != b.high.y) return a.high.y < b.high.y;
    return a.low.x < b.low.x;
  });
  std::vector<Rectangle> merged;
  for (const Rectangle& r : all) {
    const bool joins = !merged.empty() && merged.back().low.y == r.low.y && merged.back().high.y == r.high.y &&
                       r.low.x <= merged.back().high.x;
    if (joins)
      merged.back().high.x = std::max(merged.back().high.x, r.high.x);
    else
      merged.push_back(r);
  }
  all = std::move(merged);
}

void swapAxes(std::vector<Rectangle>& all) {
  for (Rectangle& r : all) {
    std::swap(r.low.x, r.low.y);
    std::swap(r.high.x, r.high.y);
  }
}

}  // namespace

Region Region::unionOf(std::span<const Box> boxes) {
  std::vector<Rectangle> all;
  all.reserve(boxes.size());
  for (const Box& box : boxes) {
    const Rectangle r{nodeOf(box.low), nodeOf(box.high)};
    if (r.low.x < r.high.x && r.low.y < r.high.y) all.push_back(r);
  }
  mergeAlongX(all);
  swapAxes(all);
  mergeAlongX(all);
  swapAxes(all);
  ClipperLib::Paths paths;
  paths.reserve(all.size());
  for (const Rectangle& r : all)
    paths.push_back({{r.low.x, r.low.y}, {r.high.x, r.low.y}, {r.high.x, r.high.y}, {r.low.x, r.high.y}});
  if (paths.size() == 1) return ClipperBridge::regionOf(paths);
  return ClipperBridge::clip(ClipperLib::ctUnion, paths, {}, ClipperLib::pftNonZero);
}

}  // namespace tessera::region
