#include "region/region.h"

#include <algorithm>
#include <cmath>

#include "region/clipper_bridge.h"

namespace tessera::region {

namespace cl = ClipperLib;

namespace {

constexpr double kMicro = 1e6;      // per metre
constexpr double kFarthest = 1e12;  // micrometres

std::int64_t micrometres(Metres m) {
  const double v = m.value() * kMicro;
  if (std::isnan(v)) return 0;
  return std::llround(std::clamp(v, -kFarthest, kFarthest));
}

// An outline with the holes in it, and what stands within the holes as pieces of their own.
void collect(const cl::PolyNode& node, std::vector<cl::Paths>& pieces) {
  for (const cl::PolyNode* outer : node.Childs) {
    cl::Paths piece{outer->Contour};
    for (const cl::PolyNode* hole : outer->Childs) {
      piece.push_back(hole->Contour);
      collect(*hole, pieces);
    }
    pieces.push_back(std::move(piece));
  }
}

}  // namespace

Node nodeOf(Point p) { return {micrometres(p.x), micrometres(p.y)}; }
Point pointOf(Node n) { return {Metres{static_cast<double>(n.x) / kMicro}, Metres{static_cast<double>(n.y) / kMicro}}; }

cl::Path ClipperBridge::pathOf(const Ring& ring) {
  cl::Path path;
  path.reserve(ring.size());
  for (const Node& n : ring) path.emplace_back(n.x, n.y);
  return path;
}

cl::Paths ClipperBridge::pathsOf(const Region& region) {
  cl::Paths paths;
  paths.reserve(region.rings_.size());
  for (const Ring& ring : region.rings_) paths.push_back(pathOf(ring));
  return paths;
}

Region ClipperBridge::regionOf(const cl::Paths& paths) {
  Region region;
  region.rings_.reserve(paths.size());
  for (const cl::Path& path : paths) {
    Ring& ring = region.rings_.emplace_back();
    ring.reserve(path.size());
    for (const cl::IntPoint& p : path) ring.push_back({p.X, p.Y});
  }
  return region;
}

Region ClipperBridge::clip(cl::ClipType how, const cl::Paths& subjects, const cl::Paths& clips, cl::PolyFillType fill) {
  cl::Clipper clipper;
  clipper.AddPaths(subjects, cl::ptSubject, true);
  clipper.AddPaths(clips, cl::ptClip, true);
  cl::Paths result;
  clipper.Execute(how, result, fill, cl::pftNonZero);
  return regionOf(result);
}

Region Region::of(std::span<const Point> outline) {
  Ring ring;
  for (const Point& p : outline) ring.push_back(nodeOf(p));
  return ClipperBridge::clip(cl::ctUnion, {ClipperBridge::pathOf(ring)}, {}, cl::pftEvenOdd);
}

Region Region::of(const Box& box) {
  const Node low = nodeOf(box.low);
  const Node high = nodeOf(box.high);
  Region region;
  if (low.x < high.x && low.y < high.y) region.rings_ = {{low, {high.x, low.y}, high, {low.x, high.y}}};
  return region;
}

Region Region::unionOf(std::span<const Region> parts) {
  cl::Paths all;
  for (const Region& part : parts)
    for (const Ring& ring : part.rings_) all.push_back(ClipperBridge::pathOf(ring));
  return ClipperBridge::clip(cl::ctUnion, all, {}, cl::pftNonZero);
}

Region operator|(const Region& a, const Region& b) {
  return ClipperBridge::clip(cl::ctUnion, ClipperBridge::pathsOf(a), ClipperBridge::pathsOf(b), cl::pftNonZero);
}
Region operator&(const Region& a, const Region& b) {
  if (a.empty() || b.empty() || !meet(a.bounds(), b.bounds())) return {};
  return ClipperBridge::clip(cl::ctIntersection, ClipperBridge::pathsOf(a), ClipperBridge::pathsOf(b), cl::pftNonZero);
}
Region operator-(const Region& a, const Region& b) {
  if (a.empty() || b.empty() || !meet(a.bounds(), b.bounds())) return a;
  return ClipperBridge::clip(cl::ctDifference, ClipperBridge::pathsOf(a), ClipperBridge::pathsOf(b), cl::pftNonZero);
}

double Region::squareMetres() const {
  double sum = 0.0;
  for (const Ring& ring : rings_) sum += cl::Area(ClipperBridge::pathOf(ring));
  return sum / (kMicro * kMicro);
}

std::vector<Region> Region::pieces() const {
  cl::Clipper clipper;
  clipper.AddPaths(ClipperBridge::pathsOf(*this), cl::ptSubject, true);
  cl::PolyTree tree;
  clipper.Execute(cl::ctUnion, tree, cl::pftNonZero, cl::pftNonZero);
  std::vector<cl::Paths> found;
  collect(tree, found);
  std::vector<Region> parts;
  parts.reserve(found.size());
  for (const cl::Paths& piece : found) parts.push_back(ClipperBridge::regionOf(piece));
  std::sort(parts.begin(), parts.end(), [](const Region& a, const Region& b) {
    const Point p = a.bounds().low;
    const Point q = b.bounds().low;
    return p.y != q.y ? p.y < q.y : p.x < q.x;
  });
  return parts;
}

Box Region::bounds() const {
  Node low = rings_.front().front();
  Node high = low;
  for (const Ring& ring : rings_) {
    for (const Node& n : ring) {
      low = {std::min(low.x, n.x), std::min(low.y, n.y)};
      high = {std::max(high.x, n.x), std::max(high.y, n.y)};
    }
  }
  return {pointOf(low), pointOf(high)};
}

}  // namespace tessera::region
