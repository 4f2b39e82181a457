// What the tool shows of its own: the picture's edge, the two points and what is between them.
#include <QLocale>

#include "ui/backdrop/backdrop_tool.h"
#include "ui/canvas/furniture.h"
#include "ui/canvas/readout.h"
#include "ui/canvas/strokes.h"

namespace tessera::ui {

void BackdropTool::paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) {
  if (!seen_ || !picture_ || picture_->fault()) return;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  QPolygonF outline;
  for (const Point& p : corners()) outline.push_back(scene.view.toPixel(p));
  QPen pen{theme.accent, 1.5};
  pen.setCapStyle(Qt::SquareCap);
  painter.setPen(pen);
  strokeDashes(painter, outline, 8.0);
  // About this corner it is turned, and its place is the one in the panel.
  paintHandle(painter, outline.front(), 4.5, theme.halo, theme.accent);
  if (drag_) {
    const floor::Backdrop led = *backdrop();
    paintReadout(painter, scene.view, theme, outline.front(), {placeText(led.origin)});
  }
  if (!scaling_ || points_.empty()) return;
  QPolygonF way;
  for (const Point& p : points_) way.push_back(scene.view.toPixel(p));
  std::optional<Metres> length = between();
  if (points_.size() == 1 && pointer_) {
    way.push_back(scene.view.toPixel(*pointer_));
    length = distance(points_.front(), *pointer_);
  }
  for (const auto& [colour, width] : {std::pair{theme.halo, 4.0}, std::pair{theme.accent, 2.0}}) {
    painter.setPen(QPen{colour, width});
    painter.drawPolyline(way);
  }
  for (std::size_t n = 0; n < points_.size(); ++n)
    paintHandle(painter, way[static_cast<qsizetype>(n)], 4.5, theme.halo, theme.accent);
  if (!length || way.size() < 2) return;
  paintHaloText(painter, (way.front() + way.back()) / 2 + QPointF{8, -8},
                tr("now %1 m", "a length").arg(QLocale().toString(length->value(), 'f', 3)), theme.text, theme.halo);
}

}  // namespace tessera::ui
