#include "ui/commission/heading_dial.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/angle.h"

namespace tessera::ui {

HeadingDial::HeadingDial(QWidget* parent) : QWidget{parent} {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  setAccessibleName(tr("Compass dial"));
}

void HeadingDial::setBearing(std::optional<Radians> bearing) {
  if (bearing == bearing_) return;
  bearing_ = bearing;
  update();
}

QSize HeadingDial::sizeHint() const { return QSize{10, 10} * fontMetrics().height(); }

void HeadingDial::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter{this};
  painter.setRenderHint(QPainter::Antialiasing);
  const double em = fontMetrics().height();
  const double radius = std::min(width(), height()) / 2.0 - 0.3 * em;
  painter.translate(width() / 2.0, height() / 2.0);
  const QColor ink = palette().color(QPalette::WindowText);
  painter.setPen(QPen{ink, em * 0.08});
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawEllipse(QPointF{}, radius, radius);
  for (int degrees = 0; degrees < 360; degrees += 15) {
    painter.save();
    painter.rotate(degrees);
    painter.drawLine(QPointF{0, -radius}, QPointF{0, -radius + (degrees % 90 == 0 ? 0.6 : 0.3) * em});
    painter.restore();
  }
  const std::array<QString, 4> winds{tr("N"), tr("E"), tr("S"), tr("W")};
  for (std::size_t i = 0; i < winds.size(); ++i) {
    const double angle = static_cast<double>(i) * kPi / 2;
    const QPointF at{std::sin(angle) * (radius - 1.3 * em), -std::cos(angle) * (radius - 1.3 * em)};
    painter.drawText(QRectF{at.x() - em, at.y() - em, 2 * em, 2 * em}, Qt::AlignCenter, winds[i]);
  }
  if (!bearing_) return;
  painter.rotate(bearing_->value() * 180 / kPi);
  const double tip = radius - 2.2 * em;
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor{0xdc, 0x35, 0x45});
  painter.drawPolygon(QPolygonF{{{0, -tip}, {0.45 * em, 0}, {-0.45 * em, 0}}});
  QColor tail = ink;
  tail.setAlphaF(0.4F);
  painter.setBrush(tail);
  painter.drawPolygon(QPolygonF{{{0, tip * 0.7}, {0.45 * em, 0}, {-0.45 * em, 0}}});
}

void HeadingDial::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    setAccessibleName(tr("Compass dial"));
    update();
  }
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
