#include "sitecheck/outline.h"

#include <algorithm>
#include <numeric>

#include "region/region.h"

namespace tessera::sitecheck {
namespace {

using region::Node;

// Twice the area of a triangle: positive where c lies to the left of a to b. Exact up to a kilometre or two; farther
// out a long double's 64 bits still tell apart what is a thousandth of a square millimetre off.
long double side(Node a, Node b, Node c) {
  return static_cast<long double>(b.x - a.x) * static_cast<long double>(c.y - a.y) -
         static_cast<long double>(b.y - a.y) * static_cast<long double>(c.x - a.x);
}

struct Edge {
  Node a;
  Node b;
  std::size_t index;
  [[nodiscard]] std::int64_t left() const { return std::min(a.x, b.x); }
  [[nodiscard]] std::int64_t right() const { return std::max(a.x, b.x); }
};

bool opposite(long double a, long double b) { return (a > 0 && b < 0) || (a < 0 && b > 0); }

bool cross(const Edge& e, const Edge& f) {
  if (std::max(e.a.y, e.b.y) < std::min(f.a.y, f.b.y) || std::max(f.a.y, f.b.y) < std::min(e.a.y, e.b.y)) return false;
  return opposite(side(e.a, e.b, f.a), side(e.a, e.b, f.b)) && opposite(side(f.a, f.b, e.a), side(f.a, f.b, e.b));
}

Point crossingOf(const Edge& e, const Edge& f) {
  const long double from = side(f.a, f.b, e.a);
  const long double to = side(f.a, f.b, e.b);
  const auto share = static_cast<double>(from / (from - to));
  const Point a = region::pointOf(e.a);
  return a + share * (region::pointOf(e.b) - a);
}

}  // namespace

std::vector<Point> withoutRepeats(std::span<const Point> line, bool closed) {
  std::vector<Point> clean;
  const auto same = [](Point a, Point b) { return region::nodeOf(a) == region::nodeOf(b); };
  for (const Point& p : line)
    if (clean.empty() || !same(clean.back(), p)) clean.push_back(p);
  while (closed && clean.size() > 1 && same(clean.front(), clean.back())) clean.pop_back();
  return clean;
}

double drawnArea(std::span<const Point> outline) {
  double sum = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    // From the first point on: far from the origin the products would swallow the area.
    const Offset a = outline[i] - outline[0];
    const Offset b = outline[(i + 1) % outline.size()] - outline[0];
    sum += a.x.value() * b.y.value() - b.x.value() * a.y.value();
  }
  return 0.5 * sum;
}

std::optional<Point> firstCrossing(std::span<const Point> outline) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < outline.size(); ++i)
    edges.push_back({region::nodeOf(outline[i]), region::nodeOf(outline[(i + 1) % outline.size()]), i});
  std::vector<std::size_t> order(edges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return edges[a].left() < edges[b].left(); });
  // From left to right, keeping those that reach as far as the next one begins.
  std::vector<std::size_t> open;
  std::optional<std::pair<std::size_t, std::size_t>> first;
  for (const std::size_t i : order) {
    std::erase_if(open, [&](std::size_t j) { return edges[j].right() < edges[i].left(); });
    for (const std::size_t j : open) {
      if (!cross(edges[i], edges[j])) continue;
      const auto pair = std::minmax(i, j);
      if (!first || std::pair{pair.first, pair.second} < *first) first = {pair.first, pair.second};
    }
    open.push_back(i);
  }
  if (!first) return std::nullopt;
  return crossingOf(edges[first->first], edges[first->second]);
}

}  // namespace tessera::sitecheck
