// Zones: colour and pattern say the kind, a name stands in the corner.
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "ui/canvas/clip.h"
#include "ui/canvas/floor_painter.h"
#include "ui/canvas/furniture.h"

namespace tessera::ui {
namespace {

constexpr double kHatchPixels = 11.0;
constexpr double kArrowPixels = 56.0;

// Lines at 45 degrees, tied to the site's origin so that they move with the floor.
void paintHatch(QPainter& painter, const View& view, const QRectF& area, double spacing, bool crossed) {
  const QPointF origin = view.toPixel({});
  const auto hatch = [&](double lean) {
    const double anchor = origin.x() - lean * origin.y();
    const double low = area.left() - std::max(lean * area.top(), lean * area.bottom());
    const double high = area.right() - std::min(lean * area.top(), lean * area.bottom());
    for (double n = std::ceil((low - anchor) / spacing); n <= (high - anchor) / spacing; n += 1.0) {
      const double at = anchor + n * spacing;
      painter.drawLine(QLineF{at + lean * area.top(), area.top(), at + lean * area.bottom(), area.bottom()});
    }
  };
  hatch(-1.0);
  if (crossed) hatch(1.0);
}

// Small arrows on a lattice tied to the site, along the direction of a one-way zone.
void paintDirection(QPainter& painter, const View& view, const QRectF& area, Radians direction) {
  const QPointF origin = view.toPixel({});
  const double step = kArrowPixels;
  for (double row = std::floor((area.top() - origin.y()) / step); row * step + origin.y() < area.bottom(); row += 1.0) {
    for (double c = std::floor((area.left() - origin.x()) / step); c * step + origin.x() < area.right(); c += 1.0) {
      painter.save();
      painter.translate(origin + QPointF{(c + 0.5) * step, (row + 0.5) * step});
      painter.rotate(-degrees(direction));
      painter.drawPolyline(QPolygonF{{-9, 0}, {9, 0}});
      painter.drawPolyline(QPolygonF{{4, -4}, {9, 0}, {4, 4}});
      painter.restore();
    }
  }
}

void paintPattern(QPainter& painter, const View& view, const floor::Zone& zone, const QPolygonF& shape, QColor colour) {
  using floor::ZoneKind;
  const bool hatched = zone.kind == ZoneKind::NoGo || zone.kind == ZoneKind::Slow;
  const bool arrows = zone.kind == ZoneKind::OneWay && zone.direction;
  if (!hatched && !arrows) return;
  QPainterPath path;
  path.addPolygon(shape);
  painter.save();
  painter.setClipPath(path, Qt::IntersectClip);
  colour.setAlpha(zone.kind == ZoneKind::Slow ? 60 : 110);
  painter.setPen(QPen{colour, 1.2});
  const QRectF area = shape.boundingRect();
  if (hatched) paintHatch(painter, view, area, kHatchPixels, zone.kind == ZoneKind::NoGo);
  if (arrows) paintDirection(painter, view, area, *zone.direction);
  painter.restore();
}

void paintName(QPainter& painter, const View& view, const floor::Zone& zone, QColor colour, QColor halo) {
  // At the vertex farthest to the upper left: it lies on the outline, wherever the zone reaches.
  const QFontMetricsF metrics{painter.font()};
  SiteBox box;
  Point corner = zone.outline.front();
  for (const Point& p : zone.outline) {
    box.add(p);
    if (p.y - p.x > corner.y - corner.x) corner = p;
  }
  const QString name = QString::fromStdString(zone.name);
  if (view.pixels(box.width()) < metrics.horizontalAdvance(name) + 16 || view.pixels(box.height()) < 40) return;
  const double down = zone.kind == floor::ZoneKind::Running ? -metrics.descent() - 4 : metrics.ascent() + 5;
  paintHaloText(painter, view.toPixel(corner) + QPointF{7, down}, name, colour, halo);
}

}  // namespace

void paintZones(QPainter& painter, const View& view, const std::vector<floor::Zone>& zones, const CanvasTheme& theme) {
  const QRectF around = QRectF{QPointF{}, view.size()}.adjusted(-8, -8, 8, 8);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const floor::Zone& zone : zones) {
    if (zone.outline.size() < 3) continue;
    QPolygonF shape;
    for (const Point& p : zone.outline) shape << view.toPixel(p);
    shape = clipped(shape, around);
    if (shape.isEmpty()) continue;
    const QColor colour = theme.zone(zone.kind);
    QColor fill = colour;
    fill.setAlpha(zone.kind == floor::ZoneKind::Running ? 0 : (theme.dark ? 34 : 26));
    painter.setPen(QPen{colour, 1.5, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin});
    painter.setBrush(fill);
    painter.drawPolygon(shape);
    paintPattern(painter, view, zone, shape, colour);
    paintName(painter, view, zone, colour, theme.halo);
  }
}

}  // namespace tessera::ui
