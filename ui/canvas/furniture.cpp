#include "ui/canvas/furniture.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

namespace tessera::ui {
namespace {

constexpr double kGridPixels = 90.0;
constexpr double kBarPixels = 80.0;

QString canvasText(const char* text) { return QCoreApplication::translate("FloorCanvas", text); }

template <class Draw>
void forEachStep(Metres from, Metres to, Metres step, Draw draw) {
  const double first = std::ceil(from / step);
  const double last = std::floor(to / step);
  if (!(last - first < 1000.0)) return;
  for (double n = first; n <= last; n += 1.0) draw(n * step);
}

void paintLines(QPainter& painter, const View& view, Metres step, const QPen& pen) {
  painter.setPen(pen);
  const SiteBox box = view.visible();
  const QSizeF size = view.size();
  forEachStep(box.low.x, box.high.x, step, [&](Metres x) {
    const double at = view.toPixel({x, Metres{}}).x();
    painter.drawLine(QLineF{at, 0, at, size.height()});
  });
  forEachStep(box.low.y, box.high.y, step, [&](Metres y) {
    const double at = view.toPixel({Metres{}, y}).y();
    painter.drawLine(QLineF{0, at, size.width(), at});
  });
}

}  // namespace

Metres niceLength(double pixelsPerMetre, double leastPixels) {
  const double least = leastPixels / pixelsPerMetre;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1 - 1e-9)) return Metres{factor * power};
  }
  return Metres{10.0 * power};
}

QString stepText(Metres at, Metres step) {
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step.value()) + 1e-9)));
  const double value = std::abs(at.value()) < step.value() / 2 ? 0.0 : at.value();
  return QLocale().toString(value, 'f', decimals);
}

QString lengthText(Metres length) {
  const QLocale locale;
  const double m = length.value();
  if (m >= 1000.0) return canvasText("%1 km").arg(locale.toString(m / 1000.0, 'g', 4));
  if (m >= 1.0) return canvasText("%1 m").arg(locale.toString(m, 'g', 4));
  if (m >= 0.01) return canvasText("%1 cm").arg(locale.toString(m * 100.0, 'g', 4));
  return canvasText("%1 mm").arg(locale.toString(m * 1000.0, 'g', 4));
}

void paintGrid(QPainter& painter, const View& view, const CanvasTheme& theme, bool onFloor) {
  const Metres step = niceLength(view.scale(), kGridPixels);
  painter.setRenderHint(QPainter::Antialiasing, false);
  if (onFloor) {
    QColor faint = theme.text;
    faint.setAlpha(theme.dark ? 30 : 22);
    paintLines(painter, view, step, QPen{faint, 0});
    return;
  }
  QColor fine = theme.grid;
  fine.setAlpha(130);
  paintLines(painter, view, step / 5.0, QPen{fine, 0});
  paintLines(painter, view, step, QPen{theme.grid, 0});
}

void paintRulers(QPainter& painter, const View& view, const CanvasTheme& theme) {
  const Metres step = niceLength(view.scale(), kGridPixels);
  const QFontMetricsF metrics{painter.font()};
  const QSizeF size = view.size();
  const QSizeF band = rulerBand(painter.font());
  const double gap = metrics.height() * 0.25;
  const SiteBox box = view.visible();
  const QColor back = theme.background;
  painter.fillRect(QRectF{0, 0, band.width(), size.height() - band.height()}, back);
  painter.fillRect(QRectF{0, size.height() - band.height(), size.width(), band.height()}, back);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(theme.quietText);
  forEachStep(box.low.x, box.high.x, step, [&](Metres x) {
    const QString text = stepText(x, step);
    const double at = std::round(view.toPixel({x, Metres{}}).x());
    const double left = at - metrics.horizontalAdvance(text) / 2;
    if (left < band.width() + gap) return;
    painter.drawLine(QLineF{at, size.height() - band.height(), at, size.height() - band.height() + 3});
    painter.drawText(QPointF{left, size.height() - metrics.descent() - 1}, text);
  });
  forEachStep(box.low.y, box.high.y, step, [&](Metres y) {
    const QString text = stepText(y, step);
    const double at = std::round(view.toPixel({Metres{}, y}).y());
    if (at > size.height() - band.height() - metrics.height() / 2) return;
    painter.drawLine(QLineF{band.width() - 3, at, band.width(), at});
    painter.drawText(QPointF{band.width() - gap - 3 - metrics.horizontalAdvance(text), at + metrics.capHeight() / 2},
                     text);
  });
  // The unit stands once, in the corner where both meet.
  const QString unit = canvasText("m");
  painter.drawText(
      QPointF{band.width() - gap - 3 - metrics.horizontalAdvance(unit), size.height() - metrics.descent() - 1}, unit);
}

QSizeF rulerBand(const QFont& font) {
  const QFontMetricsF metrics{font};
  return {metrics.horizontalAdvance(QStringLiteral("-000.00")) + metrics.height() * 0.3, metrics.height() + 4};
}

void paintScaleBar(QPainter& painter, const View& view, const CanvasTheme& theme) {
  const Metres length = niceLength(view.scale(), kBarPixels);
  const QFontMetricsF metrics{painter.font()};
  const QString text = lengthText(length);
  const double width = view.pixels(length);
  const double pad = metrics.height() * 0.5;
  const double line = metrics.height();
  const QRectF panel{view.size().width() - width - 4 * pad,
                     view.size().height() - rulerBand(painter.font()).height() - line - 2.6 * pad, width + 2 * pad,
                     line + 1.6 * pad};
  const auto crisp = [](double v) { return std::round(v) + 0.5; };
  const double y = crisp(panel.bottom() - 0.7 * pad);
  const double left = crisp(panel.left() + pad);
  QColor back = theme.panel;
  back.setAlpha(210);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(back);
  painter.drawRoundedRect(panel, 4, 4);
  painter.setPen(QPen{theme.text, 1.5, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin});
  painter.drawPolyline(QPolygonF{{left, y - 5}, {left, y}, {left + width, y}, {left + width, y - 5}});
  painter.setPen(theme.text);
  painter.drawText(QRectF{panel.left(), panel.top() + 0.3 * pad, panel.width(), line}, Qt::AlignCenter, text);
}

void paintNorthArrow(QPainter& painter, const View& view, const CanvasTheme& theme, Radians northToY) {
  const QFontMetricsF metrics{painter.font()};
  const double radius = metrics.height() * 1.15;
  const QPointF middle{view.size().width() - radius - metrics.height(), radius + metrics.height()};
  QColor back = theme.panel;
  back.setAlpha(210);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(middle);
  painter.setPen(QPen{theme.grid, 1});
  painter.setBrush(back);
  painter.drawEllipse(QPointF{}, radius, radius);
  // The y axis points up and has the bearing northToY clockwise from north: north lies so far counter-clockwise of it.
  painter.rotate(-degrees(northToY));
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.fault);
  painter.drawPolygon(QPolygonF{{0, -radius * 0.86}, {radius * 0.26, 0}, {-radius * 0.26, 0}});
  painter.setBrush(theme.silent);
  painter.drawPolygon(QPolygonF{{0, radius * 0.62}, {radius * 0.26, 0}, {-radius * 0.26, 0}});
  const QString north = QCoreApplication::translate("FloorCanvas", "N", "north, on the map's compass");
  painter.translate(0, -radius - metrics.capHeight() * 0.9);
  painter.rotate(degrees(northToY));
  paintHaloText(painter, {-metrics.horizontalAdvance(north) / 2, metrics.capHeight() / 2}, north, theme.text,
                theme.background);
  painter.restore();
}

void paintHaloText(QPainter& painter, QPointF at, const QString& text, QColor colour, QColor halo) {
  halo.setAlpha(200);
  painter.setPen(halo);
  static constexpr std::array<std::array<double, 2>, 8> kAround{
      {{-1, -1}, {0, -1.2}, {1, -1}, {-1.2, 0}, {1.2, 0}, {-1, 1}, {0, 1.2}, {1, 1}}};
  for (const auto& [x, y] : kAround) painter.drawText(at + QPointF{x, y}, text);
  painter.setPen(colour);
  painter.drawText(at, text);
}

}  // namespace tessera::ui
