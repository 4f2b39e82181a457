#include "ui/calibrate/field_chart.h"

#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "base/angle.h"

namespace tessera::ui {
namespace {

constexpr int kOutlinePoints = 120;
constexpr double kRing = 1.25;  // where the directions stand, in radii of the circle

bool isDark(const QPalette& palette) { return palette.color(QPalette::Base).lightness() < 128; }

// 1, 2 or 5 times a power of ten, so that about four fit into the span.
double niceStep(double span) {
  const double power = std::pow(10.0, std::floor(std::log10(span / 4.0)));
  const double rest = span / 4.0 / power;
  return power * (rest < 2.0 ? 1.0 : rest < 5.0 ? 2.0 : 5.0);
}

}  // namespace

// y of the field upwards.
struct FieldChart::Scale {
  QRectF area;
  calibrate::FieldPoint middle;
  double perMicrotesla = 1.0;
  double span = 1.0;  ///< µT, the shorter way across

  [[nodiscard]] QPointF at(calibrate::FieldPoint p) const {
    return {area.center().x() + (p.x - middle.x) * perMicrotesla, area.center().y() - (p.y - middle.y) * perMicrotesla};
  }
};

FieldChart::FieldChart(QWidget* parent) : QWidget{parent} {
  setObjectName(QStringLiteral("fieldChart"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  retranslate();
}

QSize FieldChart::sizeHint() const { return QSize{26, 18} * fontMetrics().height(); }
QSize FieldChart::minimumSizeHint() const { return QSize{10, 7} * fontMetrics().height(); }

void FieldChart::show(const std::vector<calibrate::FieldPoint>& points,
                      const std::optional<calibrate::CompassFit>& fit) {
  points_ = points;
  fit_ = fit;
  update();
}

QColor FieldChart::measuredColour() const {
  return isDark(palette()) ? QColor{0xe6, 0x9f, 0x00} : QColor{0xd5, 0x5e, 0x00};
}

QColor FieldChart::correctedColour() const {
  return isDark(palette()) ? QColor{0x56, 0xb4, 0xe9} : QColor{0x00, 0x72, 0xb2};
}

FieldChart::Scale FieldChart::scaleFor(const QRectF& area) const {
  calibrate::FieldPoint low;
  calibrate::FieldPoint high;
  const auto take = [&](calibrate::FieldPoint p, double margin) {
    low = {std::min(low.x, p.x - margin), std::min(low.y, p.y - margin)};
    high = {std::max(high.x, p.x + margin), std::max(high.y, p.y + margin)};
  };
  for (const auto& p : points_) take(p, 0.0);
  if (fit_) {
    take({}, kRing * fit_->radius);
    for (const auto& p : fit_->ellipse.outline(kOutlinePoints)) take(p, 0.0);
  }
  const double wide = std::max(1.1 * (high.x - low.x), 20.0);
  const double tall = std::max(1.1 * (high.y - low.y), 20.0);
  Scale scale{area, {0.5 * (low.x + high.x), 0.5 * (low.y + high.y)}, 1.0, std::min(wide, tall)};
  scale.perMicrotesla = std::min(area.width() / wide, area.height() / tall);
  return scale;
}

double FieldChart::paintLegend(QPainter& painter) const {
  const double em = fontMetrics().height();
  double x = 0.4 * em;
  const auto entry = [&](QColor colour, const QString& name) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(QPointF{x + 0.3 * em, 0.7 * em}, 0.25 * em, 0.25 * em);
    painter.setPen(palette().color(QPalette::Text));
    const double width = fontMetrics().horizontalAdvance(name);
    painter.drawText(QRectF{x + 0.8 * em, 0.1 * em, width + 1.0, 1.2 * em}, Qt::AlignLeft | Qt::AlignVCenter, name);
    x += width + 2.2 * em;
  };
  entry(measuredColour(), tr("as measured"));
  entry(correctedColour(), tr("corrected"));
  return 1.5 * em;
}

void FieldChart::paintAxes(QPainter& painter, const Scale& scale) const {
  const QRectF& area = scale.area;
  const QPointF zero = scale.at({});
  QColor faint = palette().color(QPalette::Text);
  faint.setAlphaF(0.15F);
  const double step = niceStep(scale.span);
  const int reach = static_cast<int>(std::ceil(std::max(area.width(), area.height()) / scale.perMicrotesla / step)) + 1;
  const int firstX = static_cast<int>(std::floor(scale.middle.x / step)) - reach;
  const int firstY = static_cast<int>(std::floor(scale.middle.y / step)) - reach;
  const double em = fontMetrics().height();
  const QLocale locale;
  for (int i = 0; i <= 2 * reach; ++i) {
    const double x = scale.at({(firstX + i) * step, 0.0}).x();
    const double y = scale.at({0.0, (firstY + i) * step}).y();
    painter.setPen(QPen{faint, 1.0});
    if (x > area.left() && x < area.right()) painter.drawLine(QPointF{x, area.top()}, QPointF{x, area.bottom()});
    if (y > area.top() && y < area.bottom()) painter.drawLine(QPointF{area.left(), y}, QPointF{area.right(), y});
    painter.setPen(palette().color(QPalette::PlaceholderText));
    // The axis itself marks zero.
    if (firstX + i != 0 && x > area.left() + 2 * em && x < area.right() - 4 * em)
      painter.drawText(QRectF{x - 2 * em, area.bottom() - 1.1 * em, 4 * em, em}, Qt::AlignCenter,
                       locale.toString((firstX + i) * step));
  }
  painter.drawText(QRectF{area.right() - 3 * em, area.bottom() - 1.1 * em, 2.9 * em, em},
                   Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("µT"));
  QColor ink = palette().color(QPalette::Text);
  ink.setAlphaF(0.5F);
  painter.setPen(QPen{ink, 1.0});
  if (zero.x() > area.left() && zero.x() < area.right())
    painter.drawLine(QPointF{zero.x(), area.top()}, QPointF{zero.x(), area.bottom()});
  if (zero.y() > area.top() && zero.y() < area.bottom())
    painter.drawLine(QPointF{area.left(), zero.y()}, QPointF{area.right(), zero.y()});
}

void FieldChart::paintMeasured(QPainter& painter, const Scale& scale) const {
  const double em = fontMetrics().height();
  if (fit_) {
    painter.setPen(QPen{measuredColour(), 0.08 * em});
    painter.setBrush(Qt::NoBrush);
    QPolygonF line;
    for (const auto& p : fit_->ellipse.outline(kOutlinePoints)) line << scale.at(p);
    painter.drawPolyline(line);
    const QPointF centre = scale.at(fit_->ellipse.centre);
    const QPointF across{0.35 * em, 0.0};
    const QPointF along{0.0, 0.35 * em};
    painter.drawLine(centre - across, centre + across);
    painter.drawLine(centre - along, centre + along);
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(measuredColour());
  for (const auto& p : points_) painter.drawEllipse(scale.at(p), 0.16 * em, 0.16 * em);
}

void FieldChart::paintCorrected(QPainter& painter, const Scale& scale) const {
  const double em = fontMetrics().height();
  const double radius = fit_->radius * scale.perMicrotesla;
  painter.setPen(QPen{correctedColour(), 0.08 * em});
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(scale.at({}), radius, radius);
  painter.setPen(Qt::NoPen);
  painter.setBrush(correctedColour());
  for (const auto& p : points_) painter.drawEllipse(scale.at(fit_->correction.apply(p)), 0.16 * em, 0.16 * em);
}

// A met direction is an arc, one that is missing a gap with a red cross.
void FieldChart::paintDirections(QPainter& painter, const Scale& scale) const {
  const double em = fontMetrics().height();
  const double radius = kRing * fit_->radius * scale.perMicrotesla;
  const QPointF centre = scale.at({});
  constexpr auto kSectors = calibrate::CompassFit::kSectors;
  constexpr double kWidth = 360.0 / kSectors;
  for (std::size_t i = 0; i < kSectors; ++i) {
    const double from = 180.0 + kWidth * static_cast<double>(i);
    if (fit_->met[i]) {
      painter.setPen(QPen{QColor{0x00, 0x9e, 0x73}, 0.25 * em, Qt::SolidLine, Qt::FlatCap});
      painter.setBrush(Qt::NoBrush);
      painter.drawArc(QRectF{centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius},
                      static_cast<int>((from + 1.0) * 16.0), static_cast<int>((kWidth - 2.0) * 16.0));
      continue;
    }
    const double at = (from + 0.5 * kWidth) * kPi / 180.0;
    const QPointF there = centre + radius * QPointF{std::cos(at), -std::sin(at)};
    const double arm = 0.2 * em;
    painter.setPen(QPen{QColor{0xdc, 0x35, 0x45}, 0.12 * em});
    painter.drawLine(there - QPointF{arm, arm}, there + QPointF{arm, arm});
    painter.drawLine(there - QPointF{arm, -arm}, there + QPointF{arm, -arm});
  }
}

void FieldChart::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter{this};
  painter.fillRect(rect(), palette().color(QPalette::Base));
  painter.setRenderHint(QPainter::Antialiasing);
  if (points_.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Here the field in every direction is drawn while the vehicle turns."));
    return;
  }
  const double top = paintLegend(painter);
  const Scale scale = scaleFor(QRectF{rect()}.adjusted(0.0, top, 0.0, 0.0));
  painter.setClipRect(scale.area);
  paintAxes(painter, scale);
  paintMeasured(painter, scale);
  if (!fit_) return;
  paintCorrected(painter, scale);
  paintDirections(painter, scale);
}

void FieldChart::retranslate() {
  setAccessibleName(tr("The magnetic field in every direction, measured and corrected"));
}

void FieldChart::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    update();
  }
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
