#include "ui/zone/zone_shape.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPolygonF>
#include <algorithm>

#include "region/region.h"
#include "ui/base/tidy.h"
#include "ui/canvas/route_painter.h"

namespace tessera::ui {

double squareMetres(std::span<const Point> outline) { return region::Region::of(outline).squareMetres(); }

QString areaText(double squareMetres) {
  return QCoreApplication::translate("ZoneShape", "%1 m²").arg(QLocale().toString(squareMetres, 'f', 2));
}

std::vector<Point> rectangle(Point a, Point b) {
  const auto [left, right] = std::minmax({a.x, b.x});
  const auto [low, high] = std::minmax({a.y, b.y});
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

std::vector<Point> moved(std::span<const Point> outline, Offset by) {
  std::vector<Point> there;
  for (const Point& p : outline) there.push_back(tidy(p + by));
  return there;
}

std::vector<std::size_t> zonesAt(const std::vector<floor::Zone>& zones, const View& view, QPointF pixel) {
  std::vector<std::pair<double, std::size_t>> found;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    QPolygonF shape;
    for (const Point& p : zones[i].outline) shape << view.toPixel(p);
    if (!shape.boundingRect().contains(pixel) || !shape.containsPoint(pixel, Qt::OddEvenFill)) continue;
    found.emplace_back(squareMetres(zones[i].outline), i);
  }
  std::sort(found.begin(), found.end());
  std::vector<std::size_t> order;
  for (const auto& [area, zone] : found) order.push_back(zone);
  return order;
}

std::optional<std::size_t> edgeAt(std::span<const Point> outline, const View& view, QPointF pixel, double reach) {
  std::optional<std::size_t> edge;
  for (std::size_t n = 0; n < outline.size(); ++n) {
    const double away = pixelsFromRoute(view, {outline[n], outline[(n + 1) % outline.size()]}, pixel);
    if (away > reach) continue;
    reach = away;
    edge = n;
  }
  return edge;
}

}  // namespace tessera::ui
