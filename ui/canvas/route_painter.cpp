#include "ui/canvas/route_painter.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <limits>

#include "drive/control_points.h"
#include "floor/route_legs.h"
#include "ui/canvas/clip.h"
#include "ui/canvas/furniture.h"
#include "ui/canvas/strokes.h"

namespace tessera::ui {
namespace {

constexpr double kArrowEvery = 110.0;      // pixels between arrows on a leg
constexpr double kTicksFrom = 9.0;         // pixels between control points, to draw them at all
constexpr double kNumbersFrom = 28.0;      // pixels of the shortest leg, to number the vertices
constexpr std::size_t kMostTicks = 20000;  // control points considered; a route has at most 100 000

void paintArrows(QPainter& painter, const QLineF& leg, const QRectF& around, double size, QColor colour) {
  const double length = leg.length();
  if (length < 26.0) return;
  const double count = std::max(1.0, std::floor(length / kArrowEvery));
  const auto seen = clipped(leg, around);
  if (!seen) return;
  const QPointF along = (leg.p2() - leg.p1()) / length;
  const QPointF across{-along.y(), along.x()};
  const double gap = length / count;
  const auto at = [&](QPointF p) { return QPointF::dotProduct(p - leg.p1(), along); };
  painter.setPen(QPen{colour, std::max(1.4, size * 0.36), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin});
  painter.setBrush(Qt::NoBrush);
  for (double n = std::max(0.0, std::floor(at(seen->p1()) / gap)); n < count && n * gap < at(seen->p2()); n += 1.0) {
    const QPointF tip = leg.p1() + along * ((n + 0.5) * gap + size / 2);
    painter.drawPolyline(
        QPolygonF{tip - along * size + across * size * 0.8, tip, tip - along * size - across * size * 0.8});
  }
}

void paintTicks(QPainter& painter, const View& view, const floor::Route& route, QColor colour) {
  if (view.pixels(route.controlSpacing) < kTicksFrom) return;
  const Polyline line{route.vertices};
  if (line.length() / route.controlSpacing > static_cast<double>(kMostTicks)) return;
  const auto points = drive::controlPoints(line, route.controlSpacing);
  if (!points) return;
  const SiteBox box = view.visible(10.0);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  for (const drive::ControlPoint& point : *points) {
    if (!point.vertex && box.contains(point.place)) painter.drawEllipse(view.toPixel(point.place), 2.4, 2.4);
  }
}

void paintVertices(QPainter& painter, const View& view, const CanvasTheme& theme, const floor::Route& route,
                   QColor colour, bool chosen) {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t n = 1; n < route.vertices.size(); ++n)
    shortest = std::min(shortest, view.pixels(distance(route.vertices[n - 1], route.vertices[n])));
  QFont font = painter.font();
  const QFont usual = font;
  font.setPointSizeF(font.pointSizeF() * 0.78);
  font.setBold(true);
  const QFontMetricsF metrics{font};
  const bool numbered = chosen && shortest >= kNumbersFrom;
  const double radius = numbered ? metrics.height() * 0.62 : chosen ? 4.5 : 3.0;
  const SiteBox box = view.visible(20.0);
  painter.setFont(font);
  for (std::size_t n = 0; n < route.vertices.size(); ++n) {
    if (!box.contains(route.vertices[n])) continue;
    const QPointF at = view.toPixel(route.vertices[n]);
    painter.setPen(QPen{theme.halo, 1.5});
    painter.setBrush(colour);
    painter.drawEllipse(at, radius, radius);
    if (!numbered) continue;
    painter.setPen(theme.onRoute);
    painter.drawText(QRectF{at.x() - 20, at.y() - 20, 40, 40}, Qt::AlignCenter, QString::number(n + 1));
  }
  painter.setFont(usual);
}

void paintRouteName(QPainter& painter, const View& view, const CanvasTheme& theme, const floor::Route& route,
                    QColor colour, bool chosen) {
  const QFontMetricsF metrics{painter.font()};
  const QPointF start = view.toPixel(route.vertices.front());
  if (!QRectF{QPointF{}, view.size()}.adjusted(-200, -40, 200, 40).contains(start)) return;
  // Behind the start, away from where the first leg goes.
  const QPointF away = start - view.toPixel(route.vertices[1]);
  const double length = std::max(1e-9, std::hypot(away.x(), away.y()));
  const QString name = QString::fromStdString(route.name);
  const double width = metrics.horizontalAdvance(name);
  const double reach = chosen ? 15.0 : 9.0;
  const QPointF middle =
      start + away / length * (reach + metrics.height() * 0.55) + QPointF{away.x() / length * width / 2, 0};
  const QPointF at{middle.x() - width / 2, middle.y() + metrics.capHeight() / 2};
  paintHaloText(painter, at, name, colour, theme.halo);
}

// Beside the leg's middle, where the leg has room for it: above it, or to the right of one that leads up or down.
void paintLegSpeeds(QPainter& painter, const View& view, const CanvasTheme& theme, const floor::Route& route,
                    const QRectF& drawn, QColor colour) {
  if (route.legSpeeds.empty()) return;
  const QFont usual = painter.font();
  QFont font = usual;
  font.setPointSizeF(font.pointSizeF() * 0.85);
  painter.setFont(font);
  const QFontMetricsF metrics{font};
  for (std::size_t leg = 0; leg < floor::legCount(route); ++leg) {
    const auto speed = floor::legSpeed(route, leg);
    if (!speed) continue;
    const QLineF line{view.toPixel(route.vertices[leg]), view.toPixel(route.vertices[leg + 1])};
    const QString text =
        QCoreApplication::translate("FloorCanvas", "%1 m/s").arg(QLocale().toString(speed->value(), 'g', 3));
    const double width = metrics.horizontalAdvance(text);
    if (line.length() < width + 2 * metrics.height()) continue;
    QPointF across{line.dy() / line.length(), -line.dx() / line.length()};
    if (across.y() > 0.1 || (across.y() > -0.1 && across.x() < 0)) across = -across;
    // Half the text's box reaches this far towards the leg.
    const double reach = 8.0 + std::abs(across.x()) * width / 2 + std::abs(across.y()) * metrics.height() / 2;
    const QPointF middle = line.center() + across * reach;
    const QRectF box{middle.x() - width / 2, middle.y() - metrics.height() / 2, width, metrics.height()};
    if (!box.adjusted(-2, -2, 2, 2).intersects(drawn)) continue;
    paintHaloText(painter, {box.left(), middle.y() + metrics.capHeight() / 2}, text, colour, theme.halo);
  }
  painter.setFont(usual);
}

}  // namespace

void paintRoute(QPainter& painter, const View& view, const CanvasTheme& theme, const floor::Route& route,
                RouteLook look) {
  if (route.vertices.size() < 2) return;
  const bool chosen = look == RouteLook::Chosen;
  const QColor colour = chosen ? theme.selectedRoute : theme.route;
  const double width = chosen ? 4.0 : 2.5;
  // Of a strip that comes into view only what lies in it.
  const QRectF window{QPointF{}, view.size()};
  const QRectF drawn = painter.hasClipping() ? painter.clipBoundingRect().intersected(window) : window;
  const QRectF around = drawn.adjusted(-20, -20, 20, 20);
  SiteBox box;
  for (const Point& p : route.vertices) box.add(p);
  SiteBox seenBox;
  seenBox.add(view.toSite(drawn.topLeft()));
  seenBox.add(view.toSite(drawn.bottomRight()));
  if (!box.touches(seenBox.grown(view.metres(220.0)))) return;
  painter.setRenderHint(QPainter::Antialiasing);
  std::vector<QLineF> legs;
  for (std::size_t n = 1; n < route.vertices.size(); ++n)
    legs.emplace_back(view.toPixel(route.vertices[n - 1]), view.toPixel(route.vertices[n]));
  const QColor casing = mixedColour(theme.tile, theme.halo, chosen ? 0.9 : 0.6);
  for (const auto& [pen, breadth] : {std::pair{casing, width + 2.5}, std::pair{colour, width}}) {
    painter.setPen(QPen{pen, breadth, Qt::SolidLine, Qt::SquareCap, Qt::BevelJoin});
    for (const QLineF& leg : legs) {
      if (const auto seen = clipped(leg, around)) strokeLine(painter, *seen);
    }
  }
  if (chosen) paintTicks(painter, view, route, theme.onRoute);
  for (const QLineF& leg : legs) paintArrows(painter, leg, around, chosen ? 7.0 : 5.0, colour);
  paintVertices(painter, view, theme, route, colour, chosen);
  paintLegSpeeds(painter, view, theme, route, drawn, chosen ? theme.selectedRoute : theme.quietText);
  paintRouteName(painter, view, theme, route, chosen ? theme.selectedRoute : theme.quietText, chosen);
}

double pixelsFromRoute(const View& view, const std::vector<Point>& vertices, QPointF pixel) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t n = 1; n < vertices.size(); ++n) {
    const QPointF from = view.toPixel(vertices[n - 1]);
    const QPointF leg = view.toPixel(vertices[n]) - from;
    const double square = QPointF::dotProduct(leg, leg);
    const double share = square > 0 ? std::clamp(QPointF::dotProduct(pixel - from, leg) / square, 0.0, 1.0) : 0.0;
    const QPointF gap = pixel - (from + leg * share);
    nearest = std::min(nearest, std::hypot(gap.x(), gap.y()));
  }
  return nearest;
}

}  // namespace tessera::ui
