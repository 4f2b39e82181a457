#include "sim/site_bounds.h"

#include <algorithm>

namespace tessera::sim {
namespace {

void extend(std::optional<Bounds>& bounds, Point p) {
  if (!bounds) bounds = Bounds{p, p};
  bounds->lowerLeft = {std::min(bounds->lowerLeft.x, p.x), std::min(bounds->lowerLeft.y, p.y)};
  bounds->upperRight = {std::max(bounds->upperRight.x, p.x), std::max(bounds->upperRight.y, p.y)};
}

const floor::TileType* typeOf(const floor::Site& site, const std::string& serial) {
  const auto tile =
      std::find_if(site.tiles.begin(), site.tiles.end(), [&](const auto& t) { return t.serial == serial; });
  if (tile == site.tiles.end()) return nullptr;
  const auto type =
      std::find_if(site.tileTypes.begin(), site.tileTypes.end(), [&](const auto& t) { return t.name == tile->type; });
  return type == site.tileTypes.end() ? nullptr : &*type;
}

}  // namespace

std::optional<Bounds> boundsOf(const floor::Site& site) {
  std::optional<Bounds> bounds;
  for (const floor::Placement& placement : site.placements) {
    extend(bounds, placement.origin);
    const floor::TileType* type = typeOf(site, placement.serial);
    if (type == nullptr) continue;
    extend(bounds, placement.origin + turned({type->width, type->height}, Radians{placement.quarterTurns * kPi / 2.0}));
  }
  for (const floor::LooseTag& tag : site.looseTags) extend(bounds, tag.place);
  for (const floor::Route& route : site.routes)
    for (const Point p : route.vertices) extend(bounds, p);
  return bounds;
}

Scene roomAround(const floor::Site& site, Metres margin) {
  const auto bounds = boundsOf(site);
  if (!bounds) return {};
  const Point a{bounds->lowerLeft.x - margin, bounds->lowerLeft.y - margin};
  const Point c{bounds->upperRight.x + margin, bounds->upperRight.y + margin};
  const Point b{c.x, a.y};
  const Point d{a.x, c.y};
  return {{{a, b}, {b, c}, {c, d}, {d, a}}, {}};
}

}  // namespace tessera::sim
