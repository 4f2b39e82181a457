#include "ui/lay/tile_snap.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tessera::ui {
namespace {

double besideAlong(double low, double size, double from, double to) {
  if (std::abs(to - from - size) <= 0.001) return from + std::round((low - from) / size) * size;
  // Flush with either edge, touching either, or whole tiles on from there.
  const double before = std::round((from - size - low) / size);
  const double behind = std::round((low - to) / size);
  double best = from;
  for (const double at :
       {from, to - size, from - size - std::max(before, 0.0) * size, to + std::max(behind, 0.0) * size}) {
    if (std::abs(at - low) < std::abs(best - low)) best = at;
  }
  return best;
}

// From the edge; 0 within the box.
double away(const SiteBox& box, Point p) {
  const double x = std::max({(box.low.x - p.x).value(), (p.x - box.high.x).value(), 0.0});
  const double y = std::max({(box.low.y - p.y).value(), (p.y - box.high.y).value(), 0.0});
  return std::hypot(x, y);
}

std::optional<SiteBox> nearestTile(const FloorIndex& floor, Point middle, Metres reach, const SkipTile& skip) {
  SiteBox around;
  around.add(middle);
  std::optional<SiteBox> nearest;
  double least = reach.value();
  floor.forEachTile(around.grown(reach), [&](const FloorIndex::Tile& tile) {
    const double distance = away(tile.box, middle);
    if (distance > least || (nearest && distance == least) || (skip && skip(tile))) return;
    least = distance;
    nearest = tile.box;
  });
  return nearest;
}

}  // namespace

Point toMicrometre(Point p) {
  const auto rounded = [](Metres m) { return Metres{std::round(m.value() * 1e6) / 1e6 + 0.0}; };
  return {rounded(p.x), rounded(p.y)};
}

bool lieUpon(const Box& a, const Box& b, Metres allowed) {
  return std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x) > allowed &&
         std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y) > allowed;
}

Point besideTile(Point low, Offset size, const Box& neighbour) {
  return toMicrometre(
      {Metres{besideAlong(low.x.value(), size.x.value(), neighbour.low.x.value(), neighbour.high.x.value())},
       Metres{besideAlong(low.y.value(), size.y.value(), neighbour.low.y.value(), neighbour.high.y.value())}});
}

Point snappedTile(const FloorIndex& floor, Offset size, Point low, const SkipTile& skip) {
  const Point middle = low + 0.5 * size;
  const Metres side = std::max(size.x, size.y);
  // A little farther each time: where tiles lie close by, few have to be looked at.
  for (const double reach : {1.0, 4.0, 16.0}) {
    if (const auto near = nearestTile(floor, middle, reach * side, skip)) return besideTile(low, size, boxOf(*near));
  }
  const bool any = !floor.tiles().empty();
  return besideTile(low, size, boxOf(any && !skip ? floor.tiles().front().box.low : Point{}, size));
}

bool isFree(const FloorIndex& floor, const Box& box, Metres allowed, const SkipTile& skip) {
  bool free = true;
  floor.forEachTile(siteBoxOf(box), [&](const FloorIndex::Tile& tile) {
    if (free && lieUpon(boxOf(tile.box), box, allowed) && !(skip && skip(tile))) free = false;
  });
  return free;
}

}  // namespace tessera::ui
