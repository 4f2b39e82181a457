#include "ui/commission/vehicle_preview.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace tessera::ui {

VehiclePreview::VehiclePreview(QWidget* parent) : QWidget{parent} {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void VehiclePreview::setVehicle(const floor::VehicleSetup& vehicle) {
  if (vehicle == vehicle_) return;
  vehicle_ = vehicle;
  update();
}

void VehiclePreview::setAlight(unsigned readers) {
  if (readers == alight_) return;
  alight_ = readers;
  update();
}

QSize VehiclePreview::sizeHint() const { return QSize{16, 14} * fontMetrics().height(); }
QSize VehiclePreview::minimumSizeHint() const { return QSize{10, 9} * fontMetrics().height(); }

// Drawn nose up, as on most data sheets: vehicle x is the picture's up, vehicle y its left.
void VehiclePreview::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter{this};
  painter.setRenderHint(QPainter::Antialiasing);
  QRectF bounds{-0.05, -0.05, 0.1, 0.1};
  const double r = vehicle_.readerRadius.value();
  const auto include = [&](double x, double y, double around) {
    bounds = bounds.united(QRectF{-y - around, -x - around, 2 * around, 2 * around});
  };
  for (const Point& p : vehicle_.footprint) include(p.x.value(), p.y.value(), 1e-6);
  for (const Offset& o : vehicle_.readers) include(o.x.value(), o.y.value(), r);
  include(0, vehicle_.track.value() / 2, 0.02);
  include(0, -vehicle_.track.value() / 2, 0.02);
  const double margin = fontMetrics().height() * 0.8;
  const double scale = std::min((width() - 2 * margin) / bounds.width(), (height() - 2 * margin) / bounds.height());
  if (!(scale > 0)) return;
  painter.translate(width() / 2.0, height() / 2.0);
  painter.scale(scale, scale);
  painter.translate(-bounds.center());
  drawBody(painter);
  drawReaders(painter);
}

void VehiclePreview::drawBody(QPainter& painter) const {
  const QColor ink = palette().color(QPalette::WindowText);
  QColor body = palette().color(QPalette::Highlight);
  body.setAlphaF(0.15F);
  QPen line{ink, 1.5};
  line.setCosmetic(true);
  QPolygonF outline;
  for (const Point& p : vehicle_.footprint) outline << QPointF{-p.y.value(), -p.x.value()};
  painter.setPen(line);
  painter.setBrush(body);
  painter.drawPolygon(outline);

  const double d = vehicle_.wheelDiameter.value();
  painter.setBrush(ink);
  for (const double side : {-1.0, 1.0}) {
    const double x = side * vehicle_.track.value() / 2;
    painter.drawRoundedRect(QRectF{x - d / 8, -d / 2, d / 4, d}, d / 16, d / 16);
  }
  QPen thin{ink, 1.0, Qt::DashLine};
  thin.setCosmetic(true);
  painter.setPen(thin);
  painter.drawLine(QPointF{-vehicle_.track.value() / 2, 0}, QPointF{vehicle_.track.value() / 2, 0});
  const double nose = outline.isEmpty() ? d : -outline.boundingRect().top();
  painter.drawLine(QPointF{0, 0}, QPointF{0, -nose * 0.9});
  painter.setPen(line);
  const double tip = nose * 0.06 + 0.01;
  painter.drawPolyline(QPolygonF{{{-tip, -nose * 0.9 + tip}, {0, -nose * 0.9}, {tip, -nose * 0.9 + tip}}});
}

void VehiclePreview::drawReaders(QPainter& painter) const {
  const double r = vehicle_.readerRadius.value();
  for (std::size_t i = 0; i < vehicle_.readers.size(); ++i) {
    const QPointF at{-vehicle_.readers[i].y.value(), -vehicle_.readers[i].x.value()};
    const bool alight = ((alight_ >> i) & 1U) != 0;
    QColor disc = alight ? QColor{0x22, 0xa0, 0x5a} : QColor{0xe0, 0x9a, 0x10};
    QPen line{disc, 1.5};
    line.setCosmetic(true);
    painter.setPen(line);
    disc.setAlphaF(alight ? 0.85F : 0.25F);
    painter.setBrush(disc);
    painter.drawEllipse(at, r, r);
    // Text is not scaled with the drawing.
    painter.save();
    const QPointF place = painter.worldTransform().map(at);
    const double em = fontMetrics().height();
    painter.setWorldTransform(QTransform{});
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF{place.x() - em, place.y() - em / 2, 2 * em, em}, Qt::AlignCenter, QString::number(i + 1));
    painter.restore();
  }
}

}  // namespace tessera::ui
