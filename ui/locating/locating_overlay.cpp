#include "ui/locating/locating_overlay.h"

#include <QFontMetricsF>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/canvas/furniture.h"
#include "ui/canvas/vehicle_painter.h"

namespace tessera::ui {
namespace {

constexpr double kAimRadius = 7.0;
constexpr double kReadRadius = 8.0;
constexpr double kOverlayMargin = 12.0;

QRectF boxAround(const QPolygonF& points) {
  return points.boundingRect().adjusted(-kOverlayMargin, -kOverlayMargin, kOverlayMargin, kOverlayMargin);
}

void strokeTwice(QPainter& painter, const CanvasTheme& theme, const QColor& colour, double width, Qt::PenStyle style,
                 const QPolygonF& line) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen{theme.halo, width + 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin});
  painter.drawPolyline(line);
  painter.setPen(QPen{colour, width, style, Qt::FlatCap, Qt::RoundJoin});
  painter.drawPolyline(line);
}

}  // namespace

std::vector<supervisor::ReadView> lastReads(const supervisor::VehicleView& vehicle, Seconds now) {
  std::vector<supervisor::ReadView> last;
  for (const supervisor::ReadView& read : vehicle.recentReads) {
    if (!read.place || now - read.at > LocatingOverlay::kOldestRead) continue;
    std::erase_if(last, [&](const supervisor::ReadView& r) { return r.reader == read.reader; });
    last.push_back(read);
  }
  return last;
}

void LocatingOverlay::show(std::shared_ptr<const supervisor::LocatingView> view,
                           std::vector<supervisor::ReadView> reads, Seconds now) {
  view_ = std::move(view);
  reads_ = std::move(reads);
  now_ = now;
}

bool LocatingOverlay::showsGuesses() const { return shape_ != DoubtShape::Ellipse && !view_->guesses.empty(); }
// A locator without guesses has its ellipse alone to show.
bool LocatingOverlay::showsEllipse() const { return shape_ != DoubtShape::Guesses || view_->guesses.empty(); }

QString LocatingOverlay::readText(const supervisor::ReadView& read) const {
  return tr("reader %1, %2 s ago")
      .arg(read.reader + 1)
      .arg(QLocale{}.toString(std::max(0.0, (now_ - read.at).value()), 'f', 1));
}

QRegion LocatingOverlay::extent(const View& view, const QFont& font) const {
  QRegion region;
  if (!view_) return region;
  const auto add = [&](const QRectF& box) {
    const QRectF seen = box & QRectF{QPointF{}, view.size()}.adjusted(-1, -1, 1, 1);
    if (!seen.isEmpty()) region += seen.toAlignedRect();
  };
  QPolygonF points;
  for (const Point& p : view_->guesses) points << view.toPixel(p);
  add(boxAround(points));
  const Ellipse95 ellipse = ellipseOf(view_->covariance, view.scale());
  const QPointF middle = view.toPixel(view_->estimate.position);
  add(QRectF{middle, middle}
          .adjusted(-ellipse.longAxis, -ellipse.longAxis, ellipse.longAxis, ellipse.longAxis)
          .adjusted(-kOverlayMargin, -kOverlayMargin, kOverlayMargin, kOverlayMargin));
  QPolygonF way;
  for (const Pose& p : view_->way) way << view.toPixel(p.position);
  if (view_->aim) way << view.toPixel(*view_->aim);
  add(boxAround(way));
  const QFontMetricsF metrics{font};
  for (const supervisor::ReadView& read : reads_) {
    const QPointF at = view.toPixel(*read.place);
    add(QRectF{at.x() - kOverlayMargin, at.y() - 2 * kOverlayMargin - metrics.height(),
               metrics.horizontalAdvance(readText(read)) + 3 * kOverlayMargin, 4 * kOverlayMargin + metrics.height()});
  }
  return region;
}

void LocatingOverlay::paint(QPainter& painter, const View& view, const CanvasTheme& theme) {
  if (!view_) return;
  painter.setRenderHint(QPainter::Antialiasing);
  paintReads(painter, view, theme);
  if (!view_->located) return;
  paintWay(painter, view, theme);
  paintDoubt(painter, view, theme);
}

void LocatingOverlay::paintDoubt(QPainter& painter, const View& view, const CanvasTheme& theme) const {
  if (showsGuesses()) {
    QPolygonF points;
    for (const Point& p : view_->guesses) points << view.toPixel(p);
    for (const auto& [colour, width] : {std::pair{theme.halo, 4.0}, std::pair{theme.accent, 2.4}}) {
      painter.setPen(QPen{colour, width, Qt::SolidLine, Qt::RoundCap});
      painter.drawPoints(points);
    }
  }
  const QPointF middle = view.toPixel(view_->estimate.position);
  if (showsEllipse()) {
    const Ellipse95 ellipse = ellipseOf(view_->covariance, view.scale());
    painter.save();
    painter.translate(middle);
    painter.rotate(-ellipse.degrees);
    painter.setBrush(Qt::NoBrush);
    for (const auto& pen : {QPen{theme.halo, 4.0}, QPen{theme.accent, 2.0}}) {
      painter.setPen(pen);
      painter.drawEllipse(QPointF{}, std::max(2.0, ellipse.longAxis), std::max(2.0, ellipse.shortAxis));
    }
    painter.restore();
  }
  // The estimate itself: a cross.
  for (const auto& [colour, width] : {std::pair{theme.halo, 4.0}, std::pair{theme.text, 1.6}}) {
    painter.setPen(QPen{colour, width, Qt::SolidLine, Qt::RoundCap});
    painter.drawLine(middle - QPointF{6, 0}, middle + QPointF{6, 0});
    painter.drawLine(middle - QPointF{0, 6}, middle + QPointF{0, 6});
  }
}

void LocatingOverlay::paintWay(QPainter& painter, const View& view, const CanvasTheme& theme) const {
  QPolygonF way;
  for (const Pose& p : view_->way) way << view.toPixel(p.position);
  const QPointF predicted = view.toPixel(view_->predicted.position);
  if (view_->aim) {
    const QPointF aim = view.toPixel(*view_->aim);
    QPolygonF lead;
    lead << predicted << aim;
    strokeTwice(painter, theme, theme.selectedRoute, 1.4, Qt::DashLine, lead);
    painter.setPen(QPen{theme.halo, 4.0});
    painter.drawEllipse(aim, kAimRadius, kAimRadius);
    painter.setPen(QPen{theme.selectedRoute, 2.0});
    painter.drawEllipse(aim, kAimRadius, kAimRadius);
    painter.setBrush(theme.selectedRoute);
    painter.drawEllipse(aim, 2.0, 2.0);
  }
  strokeTwice(painter, theme, theme.text, 1.6, Qt::SolidLine, way);
  // The predicted pose: an open dart along its heading.
  const double heading = view_->predicted.heading.value();
  const QPointF nose{std::cos(heading), -std::sin(heading)};
  const QPointF side{-nose.y(), nose.x()};
  QPolygonF dart;
  dart << predicted + 9 * nose << predicted - 5 * nose + 5 * side << predicted - 2 * nose
       << predicted - 5 * nose - 5 * side;
  painter.setPen(QPen{theme.text, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin});
  painter.setBrush(theme.halo);
  painter.drawPolygon(dart);
}

void LocatingOverlay::paintReads(QPainter& painter, const View& view, const CanvasTheme& theme) const {
  for (const supervisor::ReadView& read : reads_) {
    const QPointF at = view.toPixel(*read.place);
    const double age = std::clamp((now_ - read.at) / kOldestRead, 0.0, 1.0);
    QColor colour = theme.accent;
    colour.setAlphaF(static_cast<float>(1.0 - 0.7 * age));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen{theme.halo, 4.0});
    painter.drawEllipse(at, kReadRadius, kReadRadius);
    painter.setPen(QPen{colour, 2.0});
    painter.drawEllipse(at, kReadRadius, kReadRadius);
    paintHaloText(painter, at + QPointF{kReadRadius + 3, -kReadRadius}, readText(read), theme.text, theme.halo);
  }
}

}  // namespace tessera::ui
