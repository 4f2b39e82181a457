#include "ui/canvas/tile_marks.h"

#include <algorithm>

namespace tessera::ui {
namespace {

constexpr double kSignFrom = 14.0;  // pixels of a tile that has room for a sign
constexpr double kLargestSign = 12.0;

QColor tileMarkColour(TileMark::Kind kind, const CanvasTheme& theme) {
  switch (kind) {
    case TileMark::Kind::Confirmed:
      return theme.dark ? QColor{0x4c, 0xc3, 0x8a} : QColor{0x0b, 0x7a, 0x4b};
    case TileMark::Kind::Suspect:
      return theme.fault;
    case TileMark::Kind::Seen:
      break;
  }
  return theme.accent;
}

// A hook, a cross, a point.
void paintTileSign(QPainter& painter, TileMark::Kind kind, QPointF at, double size) {
  switch (kind) {
    case TileMark::Kind::Confirmed:
      painter.drawPolyline(QPolygonF{
          {at + size * QPointF{-0.7, 0.0}, at + size * QPointF{-0.15, 0.55}, at + size * QPointF{0.75, -0.55}}});
      return;
    case TileMark::Kind::Suspect:
      painter.drawLine(at + size * QPointF{-0.6, -0.6}, at + size * QPointF{0.6, 0.6});
      painter.drawLine(at + size * QPointF{-0.6, 0.6}, at + size * QPointF{0.6, -0.6});
      return;
    case TileMark::Kind::Seen:
      painter.drawPoint(at);
  }
}

}  // namespace

void paintTileMarks(QPainter& painter, const View& view, const CanvasTheme& theme, const std::vector<TileMark>& marks,
                    const QRectF& seen) {
  for (const TileMark& mark : marks) {
    const QRectF tile = QRectF{view.toPixel({mark.place.low.x, mark.place.high.y}),
                               view.toPixel({mark.place.high.x, mark.place.low.y})};
    if (!tile.intersects(seen)) continue;
    QColor colour = tileMarkColour(mark.kind, theme);
    QColor fill = colour;
    fill.setAlpha(mark.kind == TileMark::Kind::Suspect ? 80 : 45);
    painter.fillRect(tile, fill);
    const double side = std::min(tile.width(), tile.height());
    if (side < kSignFrom) continue;
    const double size = std::min(0.35 * side, kLargestSign);
    const double width = std::max(2.0, 0.28 * size);
    for (const auto& [pen, more] : {std::pair{theme.halo, 2.5}, std::pair{colour, 0.0}}) {
      painter.setPen(QPen{pen, width + more, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin});
      paintTileSign(painter, mark.kind, tile.center(), size);
    }
  }
}

}  // namespace tessera::ui
