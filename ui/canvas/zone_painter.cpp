// Zones: colour and pattern say the kind, a name stands in the corner.
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/canvas/clip.h"
#include "ui/canvas/floor_painter.h"
#include "ui/canvas/furniture.h"

namespace tessera::ui {
namespace {

constexpr double kHatchPixels = 14.0;
constexpr double kArrowPixels = 56.0;

// Lines at 45 degrees, tied to the site's origin so that they move with the floor; cut by hand, as a painter that
// clips to a polygon is many times slower.
void paintHatch(QPainter& painter, const View& view, const QPolygonF& shape, double lean) {
  const auto acrossAt = [lean](QPointF p) { return p.x() - lean * p.y(); };
  const double anchor = acrossAt(view.toPixel({}));
  double low = acrossAt(shape.first());
  double high = low;
  for (const QPointF& p : shape) {
    low = std::min(low, acrossAt(p));
    high = std::max(high, acrossAt(p));
  }
  std::vector<QPointF> cuts;
  QVector<QLineF> lines;
  for (double n = std::ceil((low - anchor) / kHatchPixels); n <= (high - anchor) / kHatchPixels; n += 1.0) {
    const double line = anchor + n * kHatchPixels;
    cuts.clear();
    QPointF from = shape.last();
    for (const QPointF& to : shape) {
      const double a = acrossAt(from) - line;
      const double b = acrossAt(to) - line;
      if ((a < 0.0) != (b < 0.0)) cuts.push_back(from + (to - from) * (a / (a - b)));
      from = to;
    }
    std::sort(cuts.begin(), cuts.end(), [](QPointF a, QPointF b) { return a.y() < b.y(); });
    for (std::size_t k = 0; k + 1 < cuts.size(); k += 2) lines.push_back({cuts[k], cuts[k + 1]});
  }
  painter.drawLines(lines);
}

// Small arrows on a lattice tied to the site, along the direction of a one-way zone.
void paintDirection(QPainter& painter, const View& view, const QPolygonF& shape, Radians direction) {
  const QPointF origin = view.toPixel({});
  const QRectF area = shape.boundingRect();
  const double step = kArrowPixels;
  for (double row = std::floor((area.top() - origin.y()) / step); row * step + origin.y() < area.bottom(); row += 1.0) {
    for (double c = std::floor((area.left() - origin.x()) / step); c * step + origin.x() < area.right(); c += 1.0) {
      const QPointF at = origin + QPointF{(c + 0.5) * step, (row + 0.5) * step};
      const QPointF reach{11.0 * cos(direction), -11.0 * sin(direction)};
      if (!shape.containsPoint(at + reach, Qt::OddEvenFill) || !shape.containsPoint(at - reach, Qt::OddEvenFill))
        continue;
      painter.save();
      painter.translate(at);
      painter.rotate(-degrees(direction));
      painter.drawPolyline(QPolygonF{{-9, 0}, {9, 0}});
      painter.drawPolyline(QPolygonF{{4, -4}, {9, 0}, {4, 4}});
      painter.restore();
    }
  }
}

void paintPattern(QPainter& painter, const View& view, const floor::Zone& zone, const QPolygonF& shape, QColor colour) {
  using floor::ZoneKind;
  colour.setAlpha(zone.kind == ZoneKind::OneWay ? 110 : 65);
  painter.setPen(QPen{colour, 0});
  painter.setBrush(Qt::NoBrush);
  // Hair lines at 45 degrees are smooth by themselves and many times faster without smoothing.
  painter.setRenderHint(QPainter::Antialiasing, zone.kind == ZoneKind::OneWay);
  if (zone.kind == ZoneKind::NoGo || zone.kind == ZoneKind::Slow) paintHatch(painter, view, shape, -1.0);
  if (zone.kind == ZoneKind::NoGo) paintHatch(painter, view, shape, 1.0);
  if (zone.kind == ZoneKind::OneWay && zone.direction) paintDirection(painter, view, shape, *zone.direction);
  painter.setRenderHint(QPainter::Antialiasing);
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
    // The name may stand a line above.
    if (painter.hasClipping() &&
        !shape.boundingRect().adjusted(-40, -40, 40, 40).intersects(painter.clipBoundingRect()))
      continue;
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
