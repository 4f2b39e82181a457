#include "ui/canvas/clip.h"

#include <algorithm>
#include <array>

namespace tessera::ui {

std::optional<QLineF> clipped(const QLineF& line, const QRectF& to) {
  const std::array<double, 4> step{-line.dx(), line.dx(), -line.dy(), line.dy()};
  const std::array<double, 4> room{line.x1() - to.left(), to.right() - line.x1(), line.y1() - to.top(),
                                   to.bottom() - line.y1()};
  double enters = 0.0;
  double leaves = 1.0;
  for (std::size_t side = 0; side < 4; ++side) {
    if (step[side] == 0.0) {
      if (room[side] < 0.0) return std::nullopt;
      continue;
    }
    const double at = room[side] / step[side];
    if (step[side] < 0.0) {
      enters = std::max(enters, at);
    } else {
      leaves = std::min(leaves, at);
    }
  }
  if (!(enters <= leaves)) return std::nullopt;
  return QLineF{line.pointAt(enters), line.pointAt(leaves)};
}

QPolygonF clipped(QPolygonF polygon, const QRectF& to) {
  // Signed distance from each side, positive inside.
  const auto inside = [&to](int side, QPointF p) {
    switch (side) {
      case 0:
        return p.x() - to.left();
      case 1:
        return to.right() - p.x();
      case 2:
        return p.y() - to.top();
      default:
        return to.bottom() - p.y();
    }
  };
  for (int side = 0; side < 4 && !polygon.isEmpty(); ++side) {
    QPolygonF kept;
    QPointF before = polygon.last();
    double insideBefore = inside(side, before);
    for (const QPointF& p : std::as_const(polygon)) {
      const double insideNow = inside(side, p);
      if ((insideBefore >= 0.0) != (insideNow >= 0.0))
        kept << before + (p - before) * (insideBefore / (insideBefore - insideNow));
      if (insideNow >= 0.0) kept << p;
      before = p;
      insideBefore = insideNow;
    }
    polygon = kept;
  }
  return polygon;
}

std::vector<QPolygonF> runsWithin(const QPolygonF& line, const QRectF& within) {
  if (within.contains(line.boundingRect())) return {line};
  std::vector<QPolygonF> runs;
  bool open = false;
  for (qsizetype n = 1; n < line.size(); ++n) {
    const QPointF a = line[n - 1];
    const QPointF b = line[n];
    const bool near = std::max(a.x(), b.x()) >= within.left() && std::min(a.x(), b.x()) <= within.right() &&
                      std::max(a.y(), b.y()) >= within.top() && std::min(a.y(), b.y()) <= within.bottom();
    if (near && !open) runs.push_back({a});
    if (near) runs.back() << b;
    open = near;
  }
  return runs;
}

}  // namespace tessera::ui
