#include "ui/canvas/strokes.h"

#include <algorithm>
#include <cmath>

namespace tessera::ui {
namespace {

constexpr double kPiece = 26.0;         // pixels; a slanting line has up to four spans for each
constexpr double kLevelPiece = 1000.0;  // a level one has a few in all

}  // namespace

void strokeLine(QPainter& painter, const QLineF& line) {
  const double piece = line.dy() == 0.0 ? kLevelPiece : kPiece;
  const int pieces = std::max(1, static_cast<int>(std::ceil(line.length() / piece)));
  QPointF from = line.p1();
  for (int n = 1; n <= pieces; ++n) {
    const QPointF to = line.pointAt(static_cast<double>(n) / pieces);
    painter.drawLine(from, to);
    from = to;
  }
}

void strokePolyline(QPainter& painter, const QPolygonF& line) {
  QPolygonF piece;
  double length = 0.0;
  for (const QPointF& p : line) {
    if (!piece.isEmpty()) {
      const double step = std::hypot(p.x() - piece.last().x(), p.y() - piece.last().y());
      if (step > kPiece) {
        if (piece.size() > 1) painter.drawPolyline(piece);
        strokeLine(painter, {piece.last(), p});
        piece.clear();
        length = 0.0;
      } else if (length + step > kPiece) {
        const QPointF last = piece.last();
        if (piece.size() > 1) painter.drawPolyline(piece);
        piece = {last};
        length = step;
      } else {
        length += step;
      }
    }
    piece << p;
  }
  if (piece.size() > 1) painter.drawPolyline(piece);
}

void strokeDashes(QPainter& painter, const QPolygonF& outline, double dash) {
  if (outline.isEmpty()) return;
  QPointF from = outline.last();
  for (const QPointF& to : outline) {
    const QLineF side{from, to};
    const double length = side.length();
    for (double at = 0.0; at < length; at += 1.5 * dash)
      painter.drawLine(side.pointAt(at / length), side.pointAt(std::min(1.0, (at + dash) / length)));
    from = to;
  }
}

QColor mixedColour(QColor under, QColor over, double share) {
  const auto mix = [share](int a, int b) { return static_cast<int>(std::lround(a + (b - a) * share)); };
  return {mix(under.red(), over.red()), mix(under.green(), over.green()), mix(under.blue(), over.blue())};
}

}  // namespace tessera::ui
