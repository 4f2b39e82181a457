#include "ui/canvas/snapper.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/base/tidy.h"
#include "ui/canvas/furniture.h"

namespace tessera::ui {
namespace {

// 1.8 m and not 1.7999999999999998 m, as sums of tile widths come out.
Point withoutDust(Point p) {
  const Point round = tidy(p);
  return distance(round, p) < Metres{1e-6} ? round : p;
}

// The nearest of what is offered within reach.
class Nearest {
public:
  Nearest(Point to, Metres reach) : to_{to}, least_{reach} {}
  void offer(Point place, Snap::Kind kind) {
    const Metres away = distance(place, to_);
    if (away > least_) return;
    least_ = away;
    found_ = Snap{withoutDust(place), kind};
  }
  [[nodiscard]] const std::optional<Snap>& found() const { return found_; }

private:
  Point to_;
  Metres least_;
  std::optional<Snap> found_;
};

std::optional<Snap> nearestVertex(const CanvasScene& scene, Point at, Metres reach, std::span<const Point> own) {
  Nearest nearest{at, reach};
  for (const Point& p : own) nearest.offer(p, Snap::Kind::Vertex);
  for (const floor::Route& route : scene.map.site().routes) {
    for (const Point& p : route.vertices) nearest.offer(p, Snap::Kind::Vertex);
  }
  for (const floor::Zone& zone : scene.map.site().zones) {
    for (const Point& p : zone.outline) nearest.offer(p, Snap::Kind::Vertex);
  }
  return nearest.found();
}

std::optional<Snap> nearestTag(const CanvasScene& scene, Point at, Metres reach) {
  Nearest nearest{at, reach};
  SiteBox box;
  box.add(at);
  // Places without a registered tag belong to the lattice as well.
  scene.floor.forEachTile(box.grown(reach), [&](const FloorIndex::Tile& tile) {
    for (const Offset& offset : scene.floor.offsetsOf(tile.shape)) nearest.offer(tile.origin + offset, Snap::Kind::Tag);
  });
  scene.map.forEachNear(at, reach, [&](const floor::PlacedTag& tag) { nearest.offer(tag.place, Snap::Kind::Tag); });
  return nearest.found();
}

std::optional<Snap> nearestOfTiles(const CanvasScene& scene, Point at, Metres reach) {
  Nearest points{at, reach};
  Nearest edges{at, 0.6 * reach};
  SiteBox box;
  box.add(at);
  scene.floor.forEachTile(box.grown(reach), [&](const FloorIndex::Tile& tile) {
    const Point low = tile.box.low;
    const Point high = tile.box.high;
    for (const Point& corner : {low, high, Point{low.x, high.y}, Point{high.x, low.y}})
      points.offer(corner, Snap::Kind::TileCorner);
    points.offer(tile.box.centre(), Snap::Kind::TileMiddle);
    const Point within{std::clamp(at.x, low.x, high.x), std::clamp(at.y, low.y, high.y)};
    for (const Point& edge :
         {Point{low.x, within.y}, Point{high.x, within.y}, Point{within.x, low.y}, Point{within.x, high.y}})
      edges.offer(edge, Snap::Kind::TileEdge);
  });
  return points.found() ? points.found() : edges.found();
}

// The foot of the perpendicular on the nearest of the eight rays, at a round distance from their beginning.
Snap inDirection(Point from, Point at, Metres step) {
  const Offset arm = at - from;
  const double turn = std::round(direction(arm).value() / (kPi / 4)) * (kPi / 4);
  const double along = arm.x.value() * std::cos(turn) + arm.y.value() * std::sin(turn);
  const double round = std::round(along / step.value()) * step.value();
  return {from + turned({Metres{round}, Metres{}}, Radians{turn}), Snap::Kind::Direction};
}

}  // namespace

Snap snapped(const CanvasScene& scene, QPointF pixel, const SnapWish& wish) {
  const Point at = scene.view.toSite(pixel);
  if (wish.off) return {tidy(at), Snap::Kind::None};
  // Round numbers a few pixels apart: one centimetre when near, more from afar.
  const Metres step{std::max(0.01, niceLength(scene.view.scale(), 2.0).value())};
  if (wish.from) {
    Snap snap = inDirection(*wish.from, at, step);
    snap.place = tidy(snap.place);
    return snap;
  }
  const Metres reach = scene.view.metres(kSnapReach);
  if (auto snap = nearestVertex(scene, at, reach, wish.vertices)) return *snap;
  // From afar everything lies within reach of some tag, and the nearest one says nothing.
  if (scene.view.pixels(scene.floor.pitch()) >= kSnapReach) {
    if (auto snap = nearestTag(scene, at, reach)) return *snap;
  }
  if (scene.view.pixels(scene.floor.smallestTile()) >= 2 * kSnapReach) {
    if (auto snap = nearestOfTiles(scene, at, reach)) return *snap;
  }
  const auto round = [step](Metres m) { return std::round(m / step) * step; };
  return {tidy({round(at.x), round(at.y)}), Snap::Kind::None};
}

}  // namespace tessera::ui
