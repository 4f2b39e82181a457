#include "ui/canvas/vehicle_painter.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/canvas/clip.h"
#include "ui/canvas/furniture.h"
#include "ui/canvas/strokes.h"

namespace tessera::ui {
namespace {

constexpr double kLeastLength = 16.0;  // pixels of a vehicle that is seen from far
constexpr int kTrailBands = 6;
constexpr double kLargestEllipse = 2000.0;

QString ageText(Seconds age) {
  const QLocale locale;
  if (age < Seconds{100.0})
    return QCoreApplication::translate("FloorCanvas", "%1 s").arg(locale.toString(age.value(), 'f', 0));
  return QCoreApplication::translate("FloorCanvas", "%1 min").arg(locale.toString(age.value() / 60.0, 'f', 0));
}

// Drawn with lines, so that it scales; 12 units across.
void paintBadge(QPainter& painter, QPointF at, const VehicleMark& mark, const CanvasTheme& theme) {
  if (mark.look == VehicleLook::Fine || mark.look == VehicleLook::Silent) return;
  const bool bad = mark.look == VehicleLook::Fault;
  painter.save();
  painter.translate(at);
  painter.setPen(QPen{theme.halo, 1.5});
  painter.setBrush(bad ? theme.fault : theme.waiting);
  const QColor sign = theme.dark ? QColor{0x10, 0x15, 0x1C} : QColor{Qt::white};
  const QPen line{sign, 2.0, Qt::SolidLine, Qt::RoundCap};
  if (bad || mark.look == VehicleLook::Obstacle) {
    painter.drawPolygon(QPolygonF{{0, -9.5}, {9.5, 7.5}, {-9.5, 7.5}});
    painter.setPen(line);
    painter.drawLine(QPointF{0, -3}, QPointF{0, 1.5});
    painter.drawPoint(QPointF{0, 4.8});
  } else {
    painter.drawEllipse(QPointF{}, 8.5, 8.5);
    painter.setPen(line);
    if (mark.look == VehicleLook::Paused) {
      painter.drawLine(QPointF{-2.2, -3}, QPointF{-2.2, 3});
      painter.drawLine(QPointF{2.2, -3}, QPointF{2.2, 3});
    } else {  // a clock
      painter.drawLine(QPointF{0, -4.5}, QPointF{0, 0});
      painter.drawLine(QPointF{0, 0}, QPointF{3, 2});
    }
  }
  painter.restore();
}

}  // namespace

QColor bodyColour(const VehicleMark& mark, const CanvasTheme& theme) {
  return mark.look == VehicleLook::Silent ? theme.silent : mark.colour;
}

QString labelOf(const VehicleMark& mark) {
  const QString name = QString::fromStdString(mark.vehicle->name);
  if (mark.look != VehicleLook::Silent || !mark.vehicle->link.lastHeard) return name;
  return QCoreApplication::translate("FloorCanvas", "%1, %2 ago", "a vehicle's name, how long ago it was last heard")
      .arg(name, ageText(mark.vehicle->link.age));
}

bool isDrawn(const Ellipse95& ellipse) { return ellipse.longAxis > 2.0 && ellipse.longAxis < kLargestEllipse; }

// Over the body, as the doubt is mostly smaller than it; white or black there, the vehicle's colour around it.
void paintDoubt(QPainter& painter, const CanvasTheme& theme, const Ellipse95& ellipse, QColor colour) {
  QColor fill = theme.onRoute;
  fill.setAlpha(50);
  painter.save();
  painter.rotate(-ellipse.degrees);
  painter.setBrush(fill);
  painter.setPen(QPen{theme.onRoute, 2.6});
  painter.drawEllipse(QPointF{}, ellipse.longAxis, ellipse.shortAxis);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen{colour, 1.2});
  painter.drawEllipse(QPointF{}, ellipse.longAxis, ellipse.shortAxis);
  painter.restore();
}

QPolygonF footprintOf(const VehicleMark& mark, const View& view, const Pose& at) {
  static const std::vector<Point> kUnknown{{Metres{-0.2}, Metres{-0.15}},
                                           {Metres{0.2}, Metres{-0.15}},
                                           {Metres{0.2}, Metres{0.15}},
                                           {Metres{-0.2}, Metres{0.15}}};
  const bool known = mark.setup != nullptr && mark.setup->footprint.size() >= 3;
  const std::vector<Point>& outline = known ? mark.setup->footprint : kUnknown;
  SiteBox box;
  for (const Point& p : outline) box.add(p);
  const double length = view.pixels(std::max(box.width(), box.height()));
  const double grow = std::max(1.0, kLeastLength / std::max(length, 1e-6));
  QPolygonF shape;
  for (const Point& p : outline) shape << view.toPixel(placeOf(at, grow * (p - Point{})));
  return shape;
}

QRectF extentOf(const VehicleMark& mark, const View& view, const QFont& font, const CanvasLayers& layers) {
  const QFontMetricsF metrics{font};
  const QPointF at = view.toPixel(mark.pose.position);
  QRectF extent = footprintOf(mark, view, mark.pose).boundingRect();
  extent |= footprintOf(mark, view, mark.vehicle->predicted).boundingRect();
  const double reach = extent.height() / 2 + 2.2 * metrics.height();
  extent |= QRectF{at.x(), at.y(), 0, 0}.adjusted(-reach, -reach, reach, reach);
  const double wide = metrics.horizontalAdvance(labelOf(mark)) / 2 + metrics.height() * 1.5;
  extent |= QRectF{at.x() - wide, at.y(), 2 * wide, extent.height() / 2 + 2 * metrics.height()};
  if (mark.vehicle->obstacle) {
    const double far = view.pixels(*mark.vehicle->obstacle + Metres{1.0});
    extent |= QRectF{at.x() - far, at.y() - far, 2 * far, 2 * far};
  }
  if (layers.uncertainty) {
    const double axis = std::min(kLargestEllipse, ellipseOf(mark.vehicle->covariance, view.scale()).longAxis);
    extent |= QRectF{at.x() - axis, at.y() - axis, 2 * axis, 2 * axis};
  }
  return extent.adjusted(-14, -14, 14, 14);
}

namespace {

// Hair lines side by side: the painter has a short way for them, and a hundred trails are the most that it draws.
void strokeHairs(QPainter& painter, const View& view, const QPolygonF& line, QColor colour) {
  painter.setPen(QPen{colour, 0});
  const int hairs = std::max(2, static_cast<int>(std::lround(2 * view.devicePixelRatio())));
  for (int n = 0; n < hairs; ++n) {
    const double aside = (n - (hairs - 1) / 2.0) * 0.7 / view.devicePixelRatio();
    painter.drawPolyline(line.translated(aside, -aside));
  }
}

QColor trailColour(QColor under, QColor colour, double age) { return mixedColour(under, colour, 0.85 - 0.7 * age); }

}  // namespace

void paintTrail(QPainter& painter, const View& view, const Trail& trail, Seconds now, QColor colour, QColor under,
                const QRectF& within) {
  for (const Trail::Piece& piece : trail.pieces(view, now, kTrailBands)) {
    for (const QPolygonF& line : runsWithin(piece.line, within.adjusted(-4, -4, 4, 4)))
      strokeHairs(painter, view, line, trailColour(under, colour, piece.age));
  }
}

void paintTrailEnd(QPainter& painter, const View& view, const Trail& trail, Seconds since, QColor colour,
                   QColor under) {
  const double young = 0.5 / kTrailBands;
  for (const QPolygonF& line : trail.since(view, since))
    strokeHairs(painter, view, line, trailColour(under, colour, young));
}

bool hasGhost(const View& view, const VehicleMark& mark) {
  const supervisor::VehicleView& v = *mark.vehicle;
  return mark.look != VehicleLook::Silent && v.task == supervisor::Task::Running &&
         view.pixels(distance(v.predicted.position, v.pose.position)) > 3.0;
}

void paintGhost(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark,
                const Pose& at) {
  QColor ghost = bodyColour(mark, theme);
  ghost.setAlpha(150);
  painter.setPen(QPen{ghost, 1.2, Qt::SolidLine, Qt::FlatCap});
  strokeDashes(painter, footprintOf(mark, view, at), 5.0);
}

void paintVehicle(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark) {
  const QPolygonF shape = footprintOf(mark, view, mark.pose);
  const QColor colour = bodyColour(mark, theme);
  if (mark.chosen) {
    QColor glow = theme.accent;
    painter.setPen(QPen{glow, 7.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin});
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(shape);
  }
  QColor fill = colour;
  fill.setAlpha(mark.look == VehicleLook::Silent ? 120 : 245);
  painter.setPen(QPen{theme.halo, 3.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin});
  painter.setBrush(fill);
  painter.drawPolygon(shape);
  const Qt::PenStyle style = mark.look == VehicleLook::Silent ? Qt::DashLine : Qt::SolidLine;
  painter.setPen(QPen{mark.look == VehicleLook::Fault ? theme.fault : colour.darker(theme.dark ? 70 : 130), 1.6, style,
                      Qt::RoundCap, Qt::RoundJoin});
  painter.setBrush(Qt::NoBrush);
  painter.drawPolygon(shape);

  // A chevron at the nose says where forward is.
  const QPointF at = view.toPixel(mark.pose.position);
  const QPointF nose{cos(mark.pose.heading), -sin(mark.pose.heading)};
  const QPointF side{nose.y(), -nose.x()};
  double front = 0.0;
  for (const QPointF& p : shape) front = std::max(front, QPointF::dotProduct(p - at, nose));
  const double size = std::clamp(front * 0.55, 3.5, 16.0);
  const QPointF tip = at + nose * (front - size * 0.35);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.onRoute);
  painter.drawPolygon(QPolygonF{tip, tip - nose * size + side * size * 0.62, tip - nose * size * 0.7,
                                tip - nose * size - side * size * 0.62});
  const QRectF box = shape.boundingRect();
  paintBadge(painter, {box.right() + 2, box.top() - 2}, mark, theme);
}

void paintObstacle(QPainter& painter, const View& view, const CanvasTheme& theme, const VehicleMark& mark) {
  if (!mark.vehicle->obstacle || mark.look == VehicleLook::Silent) return;
  const QPointF at = view.toPixel(mark.pose.position);
  const QPointF nose{cos(mark.pose.heading), -sin(mark.pose.heading)};
  const QPointF side{nose.y(), -nose.x()};
  double front = 0.0;
  for (const QPointF& p : footprintOf(mark, view, mark.pose))
    front = std::max(front, QPointF::dotProduct(p - at, nose));
  const double reach = std::clamp(view.pixels(Metres{0.18}), 6.0, 40.0);
  const QPointF middle = at + nose * (front + view.pixels(*mark.vehicle->obstacle));
  // Something ahead is no alarm by itself; that it keeps the vehicle waiting is.
  const bool waits = mark.look == VehicleLook::Obstacle;
  painter.setPen(QPen{waits ? theme.fault : theme.quietText, waits ? 3.0 : 2.0, Qt::SolidLine, Qt::RoundCap});
  painter.drawLine(middle - side * reach, middle + side * reach);
}

QSizeF labelSize(const QString& text, const QFont& font) {
  const QFontMetricsF metrics{font};
  return {std::ceil(metrics.horizontalAdvance(text) + metrics.height() * 0.7) + 4, std::ceil(metrics.height()) + 6};
}

void paintVehicleLabel(QPainter& painter, const CanvasTheme& theme, const VehicleMark& mark) {
  const QString text = labelOf(mark);
  const QRectF pill = QRectF{QPointF{}, labelSize(text, painter.font())}.adjusted(1.5, 1.5, -1.5, -1.5);
  QColor back = theme.panel;
  back.setAlpha(215);
  painter.setBrush(back);
  painter.setPen(mark.chosen ? QPen{theme.accent, 1.6} : QPen{bodyColour(mark, theme), 1.0});
  painter.drawRoundedRect(pill, 4, 4);
  painter.setPen(mark.look == VehicleLook::Silent ? theme.quietText : theme.text);
  painter.drawText(pill, Qt::AlignCenter, text);
}

void paintFlash(QPainter& painter, QPointF at, QColor colour, double age) {
  const double radius = 4.0 + 9.0 * age;
  colour.setAlphaF(static_cast<float>(std::clamp(1.0 - age, 0.0, 1.0)));
  painter.setPen(QPen{colour, 2.0});
  QColor fill = colour;
  fill.setAlphaF(fill.alphaF() * 0.35F);
  painter.setBrush(fill);
  painter.drawEllipse(at, radius, radius);
}

Ellipse95 ellipseOf(const std::array<double, 9>& covariance, double pixelsPerMetre) {
  const double xx = covariance[0];
  const double xy = (covariance[1] + covariance[3]) / 2;
  const double yy = covariance[4];
  const double middle = (xx + yy) / 2;
  const double swing = std::hypot((xx - yy) / 2, xy);
  // 5.991: 95 % of the chi-squared distribution with two degrees of freedom.
  const auto axis = [pixelsPerMetre](double variance) {
    return std::isfinite(variance) ? std::sqrt(5.991 * std::max(0.0, variance)) * pixelsPerMetre : 0.0;
  };
  return {axis(middle + swing), axis(middle - swing), 0.5 * std::atan2(2 * xy, xx - yy) * 180.0 / kPi};
}

}  // namespace tessera::ui
