// What the route tool shows: the unfinished route with its rubber band, the handles of the chosen one, the numbers.
#include <QFontMetricsF>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "floor/bearing.h"
#include "ui/canvas/clip.h"
#include "ui/canvas/route_painter.h"
#include "ui/route/route_tool.h"

namespace tessera::ui {
namespace {

constexpr double kHandle = 5.5;
constexpr double kLegHandleFrom = 44.0;

// "1.20 m, 090°": how long the way is and where it leads, clockwise from north.
QString legText(Point from, Point to, Radians northToY) {
  double bearing = std::round(degrees(floor::bearingOfHeading(direction(to - from), northToY)));
  if (bearing < 0.0) bearing += 360.0;
  return RouteTool::tr("%1 m, %2°", "length and bearing of a leg")
      .arg(QLocale().toString(distance(from, to).value(), 'f', 2))
      .arg(static_cast<int>(bearing) % 360, 3, 10, QLatin1Char('0'));
}

QString placeText(Point p) {
  const QLocale locale;
  return RouteTool::tr("x %1 m, y %2 m")
      .arg(locale.toString(p.x.value(), 'f', 2), locale.toString(p.y.value(), 'f', 2));
}

QString kindText(Snap::Kind kind) {
  switch (kind) {
    case Snap::Kind::Vertex:
      return RouteTool::tr("vertex");
    case Snap::Kind::Tag:
      return RouteTool::tr("tag");
    case Snap::Kind::TileCorner:
      return RouteTool::tr("tile corner");
    case Snap::Kind::TileMiddle:
      return RouteTool::tr("tile middle");
    case Snap::Kind::TileEdge:
      return RouteTool::tr("tile edge");
    case Snap::Kind::Direction:
      return RouteTool::tr("45° steps");
    case Snap::Kind::None:
      break;
  }
  return {};
}

// Beside the cursor, and on its other side at the window's edge.
void paintReadout(QPainter& painter, const View& view, const CanvasTheme& theme, QPointF at, const QStringList& lines) {
  const QFontMetricsF metrics{painter.font()};
  double width = 0.0;
  for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));
  const double pad = metrics.height() * 0.4;
  QRectF panel{at.x() + 18, at.y() + 18, width + 2 * pad, metrics.height() * static_cast<double>(lines.size()) + pad};
  if (panel.right() > view.size().width()) panel.moveRight(at.x() - 18);
  if (panel.bottom() > view.size().height()) panel.moveBottom(at.y() - 18);
  QColor back = theme.panel;
  back.setAlpha(235);
  painter.setPen(QPen{theme.grid, 1});
  painter.setBrush(back);
  painter.drawRoundedRect(panel, 4, 4);
  for (qsizetype n = 0; n < lines.size(); ++n) {
    painter.setPen(n == 0 ? theme.text : theme.quietText);
    painter.drawText(QPointF{panel.left() + pad,
                             panel.top() + pad / 2 + metrics.ascent() + metrics.height() * static_cast<double>(n)},
                     lines[n]);
  }
}

void paintHandle(QPainter& painter, QPointF at, double radius, QColor fill, QColor edge) {
  painter.setPen(QPen{edge, 2.0});
  painter.setBrush(fill);
  painter.drawEllipse(at, radius, radius);
}

}  // namespace

void RouteTool::paint(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) {
  painter.setRenderHint(QPainter::Antialiasing);
  if (const floor::Route* chosen = route()) {
    floor::Route shown = *chosen;
    if (drag_) shown.vertices = drag_->vertices;
    paintRoute(painter, scene.view, theme, shown, drawing_ ? RouteLook::Quiet : RouteLook::Chosen);
    if (!drawing_) paintHandles(painter, scene, theme, shown);
  }
  if (drawing_) paintDraft(painter, scene, theme);
}

void RouteTool::paintHandles(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme,
                             const floor::Route& shown) {
  const View& view = scene.view;
  const SiteBox seen = view.visible(20.0);
  for (std::size_t n = 0; !drag_ && n + 1 < shown.vertices.size(); ++n) {
    const Point middle = shown.vertices[n] + 0.5 * (shown.vertices[n + 1] - shown.vertices[n]);
    if (view.pixels(distance(shown.vertices[n], shown.vertices[n + 1])) < kLegHandleFrom || !seen.contains(middle))
      continue;
    const bool hot = hover_ == Hit{Hit::Kind::Middle, n};
    paintHandle(painter, view.toPixel(middle), hot ? kHandle + 1 : kHandle - 1, hot ? theme.accent : theme.halo,
                hot ? theme.halo : theme.selectedRoute);
  }
  const QFontMetricsF metrics{painter.font()};
  const auto ring = [&](std::size_t n, double width) {
    painter.setPen(QPen{theme.accent, width});
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(view.toPixel(shown.vertices[n]), metrics.height() * 0.72, metrics.height() * 0.72);
  };
  if (hover_.kind == Hit::Kind::Vertex && hover_.index < shown.vertices.size()) ring(hover_.index, 2.0);
  const auto current = drag_ ? std::optional{drag_->index} : vertex_;
  if (!current || *current >= shown.vertices.size()) return;
  ring(*current, 3.0);
  if (!drag_ || !drag_->moved) return;
  paintSnap(painter, view, theme);
  const Point at = shown.vertices[*current];
  const Radians north = scene.map.site().northToY;
  QStringList lines{placeText(at)};
  if (*current > 0) lines << legText(shown.vertices[*current - 1], at, north);
  if (*current + 1 < shown.vertices.size()) lines << legText(at, shown.vertices[*current + 1], north);
  if (const QString kind = pointer_ ? kindText(pointer_->kind) : QString{}; !kind.isEmpty()) lines << kind;
  paintReadout(painter, view, theme, view.toPixel(at), lines);
}

void RouteTool::paintDraft(QPainter& painter, const CanvasScene& scene, const CanvasTheme& theme) {
  const View& view = scene.view;
  const QRectF around = QRectF{QPointF{}, view.size()}.adjusted(-20, -20, 20, 20);
  if (draft_.size() >= 2) {
    paintRoute(painter, view, theme, floor::Route{{}, draft_, Metres{1e9}}, RouteLook::Chosen);
  } else if (draft_.size() == 1) {
    paintHandle(painter, view.toPixel(draft_.front()), kHandle, theme.selectedRoute, theme.halo);
  }
  if (!pointer_) return;
  QStringList lines;
  if (!draft_.empty()) {
    const QLineF band{view.toPixel(draft_.back()), view.toPixel(pointer_->place)};
    if (const auto seen = clipped(band, around)) {
      painter.setPen(QPen{theme.accent, 2.0, Qt::DashLine, Qt::RoundCap});
      painter.drawLine(*seen);
    }
    if (draft_.back() != pointer_->place) lines << legText(draft_.back(), pointer_->place, scene.map.site().northToY);
  }
  lines << placeText(pointer_->place);
  if (const QString kind = kindText(pointer_->kind); !kind.isEmpty()) lines << kind;
  paintSnap(painter, view, theme);
  paintReadout(painter, view, theme, view.toPixel(pointer_->place), lines);
}

void RouteTool::paintSnap(QPainter& painter, const View& view, const CanvasTheme& theme) const {
  if (!pointer_) return;
  const QPointF at = view.toPixel(pointer_->place);
  painter.setPen(QPen{theme.accent, 2.0});
  painter.setBrush(Qt::NoBrush);
  switch (pointer_->kind) {
    case Snap::Kind::Vertex:
    case Snap::Kind::Tag:
      painter.drawEllipse(at, 8.0, 8.0);
      break;
    case Snap::Kind::TileCorner:
    case Snap::Kind::TileMiddle:
      painter.drawRect(QRectF{at.x() - 6, at.y() - 6, 12, 12});
      break;
    case Snap::Kind::TileEdge:
      painter.drawPolygon(QPolygonF{at + QPointF{0, -8}, at + QPointF{8, 0}, at + QPointF{0, 8}, at + QPointF{-8, 0}});
      break;
    case Snap::Kind::Direction:
    case Snap::Kind::None:
      painter.drawLine(at - QPointF{6, 0}, at + QPointF{6, 0});
      painter.drawLine(at - QPointF{0, 6}, at + QPointF{0, 6});
      break;
  }
}

}  // namespace tessera::ui
