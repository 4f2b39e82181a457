// Points and straight ways against a region, by counting the edges that they cross.
#include <algorithm>
#include <cmath>
#include <limits>

#include "region/region.h"

namespace tessera::region {
namespace {

struct Vector {
  double x;
  double y;
};
Vector between(Node a, Node b) { return {static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y)}; }
double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }

template <class Visit>
void forEachEdge(const std::vector<Ring>& rings, Visit visit) {
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
}

// Distance in micrometres at which a point counts as on an edge.
constexpr double kOnEdge = 2.0;

}  // namespace

bool Region::contains(Point p) const {
  const Node n = nodeOf(p);
  bool inside = false;
  bool onEdge = false;
  forEachEdge(rings_, [&](Node a, Node b) {
    const Vector edge = between(a, b);
    const Vector to = between(a, n);
    const double length = std::hypot(edge.x, edge.y);
    const double along = length > 0 ? dot(edge, to) / length : 0.0;
    const double off = length > 0 ? std::abs(cross(edge, to)) / length : std::hypot(to.x, to.y);
    onEdge = onEdge || (off <= kOnEdge && along >= -kOnEdge && along <= length + kOnEdge);
    if ((a.y > n.y) == (b.y > n.y)) return;
    const double at = static_cast<double>(a.x) + edge.x * to.y / edge.y;
    if (static_cast<double>(n.x) < at) inside = !inside;
  });
  return inside || onEdge;
}

Point Region::nearestOnEdge(Point p) const {
  const Node n = nodeOf(p);
  Point nearest = pointOf(rings_.front().front());
  double least = std::numeric_limits<double>::infinity();
  forEachEdge(rings_, [&](Node a, Node b) {
    const Vector edge = between(a, b);
    const Vector to = between(a, n);
    const double square = dot(edge, edge);
    const double share = square > 0.0 ? std::clamp(dot(edge, to) / square, 0.0, 1.0) : 0.0;
    const double away = std::hypot(to.x - share * edge.x, to.y - share * edge.y);
    if (away >= least) return;
    least = away;
    nearest = pointOf(a) + share * (pointOf(b) - pointOf(a));
  });
  return nearest;
}

std::vector<Stretch> Region::within(Point from, Point to) const {
  const Node a = nodeOf(from);
  const Vector way = between(a, nodeOf(to));
  std::vector<double> cuts{0.0, 1.0};
  const double square = dot(way, way);
  if (square <= 0.0) return contains(from) ? std::vector<Stretch>{{0.0, 1.0}} : std::vector<Stretch>{};
  forEachEdge(rings_, [&](Node p, Node q) {
    const Vector edge = between(p, q);
    const Vector start = between(a, p);
    const double across = cross(way, edge);
    if (across == 0.0) {
      // Side by side: the edge's ends may be where the way enters or leaves.
      cuts.push_back(dot(start, way) / square);
      cuts.push_back(dot(between(a, q), way) / square);
      return;
    }
    const double onEdge = cross(start, way) / across;
    if (onEdge >= -1e-9 && onEdge <= 1.0 + 1e-9) cuts.push_back(cross(start, edge) / across);
  });
  std::sort(cuts.begin(), cuts.end());
  std::vector<Stretch> inside;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double low = std::max(cuts[i], 0.0);
    const double high = std::min(cuts[i + 1], 1.0);
    if (!(high > low)) continue;
    const double middle = 0.5 * (low + high);
    if (!contains(from + middle * (to - from))) continue;
    if (!inside.empty() && inside.back().to >= low)
      inside.back().to = high;
    else
      inside.push_back({low, high});
  }
  return inside;
}

}  // namespace tessera::region
