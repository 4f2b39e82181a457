// A floor of a hundred thousand tiles is a handful of rectangles once neighbours are put together; Clipper then has
// little left to do. Where they do not fit, it is given them block by block: its time grows faster than their number.
#include <algorithm>
#include <cmath>
#include <map>

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

ClipperLib::Paths pathsOfAll(const std::vector<Rectangle>& all) {
  ClipperLib::Paths paths;
  paths.reserve(all.size());
  for (const Rectangle& r : all)
    paths.push_back({{r.low.x, r.low.y}, {r.high.x, r.low.y}, {r.high.x, r.high.y}, {r.low.x, r.high.y}});
  return paths;
}

Region unionOfSome(const ClipperLib::Paths& paths) {
  if (paths.size() == 1) return ClipperBridge::regionOf(paths);
  return ClipperBridge::clip(ClipperLib::ctUnion, paths, {}, ClipperLib::pftNonZero);
}

// Unions of what begins in the same square of the floor, some hundred rectangles each, then the union of those.
Region unionByBlocks(const std::vector<Rectangle>& all) {
  constexpr std::size_t perBlock = 400;
  Node low = all.front().low;
  Node high = low;
  for (const Rectangle& r : all) {
    low = {std::min(low.x, r.low.x), std::min(low.y, r.low.y)};
    high = {std::max(high.x, r.low.x), std::max(high.y, r.low.y)};
  }
  const double area = static_cast<double>(high.x - low.x + 1) * static_cast<double>(high.y - low.y + 1);
  const double side = std::sqrt(area * perBlock / static_cast<double>(all.size())) + 1.0;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<Rectangle>> blocks;
  for (const Rectangle& r : all)
    blocks[{static_cast<std::int64_t>(static_cast<double>(r.low.x - low.x) / side),
            static_cast<std::int64_t>(static_cast<double>(r.low.y - low.y) / side)}]
        .push_back(r);
  std::vector<Region> parts;
  parts.reserve(blocks.size());
  for (const auto& [place, block] : blocks) parts.push_back(unionOfSome(pathsOfAll(block)));
  return Region::unionOf(parts);
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
  constexpr std::size_t many = 2000;
  return all.size() > many ? unionByBlocks(all) : unionOfSome(pathsOfAll(all));
}

}  // namespace tessera::region
