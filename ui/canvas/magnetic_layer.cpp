#include "ui/canvas/magnetic_layer.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

#include "locate/magnetic_map.h"
#include "ui/canvas/furniture.h"

namespace tessera::ui {
namespace {

constexpr double kWorthSeeing = 0.05;                             // share of what could be known
constexpr double kMostOpaque = 0.75;                              // so that tags and seams are seen through it
constexpr std::array kFullScales{5.0, 10.0, 20.0, 45.0};          // degrees
constexpr std::array<QRgb, 2> kRightColours{0x2166AC, 0x5AA0E6};  // light, dark; told apart by colour-blind eyes
constexpr std::array<QRgb, 2> kLeftColours{0xD6610A, 0xFF9A3C};
constexpr std::array<QRgb, 2> kStraightColours{0xE3E6EA, 0x4A525C};

// -1: to the right, 0: not at all, 1: to the left.
QColor colourOf(double share, bool dark) {
  const auto of = [dark](const std::array<QRgb, 2>& pair) { return QColor::fromRgb(pair[dark ? 1 : 0]); };
  const QColor from = of(kStraightColours);
  const QColor to = of(share < 0.0 ? kRightColours : kLeftColours);
  const float t = static_cast<float>(std::min(1.0, std::abs(share)));
  return QColor::fromRgbF(from.redF() + t * (to.redF() - from.redF()),
                          from.greenF() + t * (to.greenF() - from.greenF()),
                          from.blueF() + t * (to.blueF() - from.blueF()));
}

}  // namespace

void MagneticLayer::set(std::shared_ptr<const locate::MagneticMap> map) {
  map_ = std::move(map);
  picture_.forget();
  full_.reset();
}

double MagneticLayer::fullDegrees() const {
  if (full_) return *full_;
  double most = 0.0;
  if (map_)
    map_->forEach([&](locate::MagneticNode, const locate::MagneticValue& value) {
      if (value.known() > 0.5) most = std::max(most, std::abs(degrees(Radians{value.deviation})));
    });
  const auto scale = std::find_if(kFullScales.begin(), kFullScales.end(), [most](double s) { return s >= most; });
  full_ = scale == kFullScales.end() ? kFullScales.back() : *scale;
  return *full_;
}

void MagneticLayer::paint(QPainter& painter, const View& view, const CanvasTheme& theme) {
  if (!map_ || map_->empty()) return;
  picture_.paint(painter, view, theme, [&](QPainter& keeping) {
    const QRectF window{QPointF{}, view.size()};
    const Metres half = 0.5 * locate::MagneticMap::kSpacing;
    const double full = fullDegrees();
    map_->forEach([&](locate::MagneticNode node, const locate::MagneticValue& value) {
      if (value.known() < kWorthSeeing) return;
      const Point middle = locate::MagneticMap::placeOf(node);
      const QRectF cell{view.toPixel({middle.x - half, middle.y + half}),
                        view.toPixel({middle.x + half, middle.y - half})};
      if (!cell.intersects(window)) return;
      QColor colour = colourOf(degrees(Radians{value.deviation}) / full, theme.dark);
      colour.setAlphaF(static_cast<float>(kMostOpaque * std::min(1.0, 0.25 + value.known())));
      keeping.fillRect(cell, colour);
    });
  });
}

void MagneticLayer::paintLegend(QPainter& painter, const View& view, const CanvasTheme& theme, double below) const {
  const QFontMetricsF metrics{painter.font()};
  const double line = metrics.height() * 1.25;
  const double pad = metrics.height() * 0.6;
  const double left = rulerBand(painter.font()).width() + pad;
  const double most = view.size().width() - left - 8 * metrics.height();  // the north arrow stands at the right
  if (most < 6 * metrics.height()) return;
  const bool none = !map_ || map_->empty();
  const QString title = tr("Iron in the floor turns compasses by");
  const QString empty = tr("Nothing is known of iron in the floor yet: drive over it to learn it.");
  const double wide = std::min(most - 2 * pad, std::max(metrics.horizontalAdvance(title), 14 * metrics.height()));
  const QRectF room{0, 0, wide, 10 * line};
  const QRectF text = metrics.boundingRect(room, Qt::TextWordWrap, none ? empty : title);
  const QRectF panel{left, pad + below, wide + 2 * pad, text.height() + (none ? 0.0 : 2.2 * line) + 1.2 * pad};
  QColor back = theme.panel;
  back.setAlpha(225);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(back);
  painter.drawRoundedRect(panel, 4, 4);
  painter.setPen(theme.text);
  QRectF row{panel.left() + pad, panel.top() + 0.6 * pad, wide, text.height()};
  painter.drawText(row, Qt::TextWordWrap, none ? empty : title);
  if (none) return;
  const QRectF bar{row.left(), row.bottom() + 0.3 * line, wide, 0.6 * line};
  QLinearGradient colours{bar.topLeft(), bar.topRight()};
  // From the left end, as the nose would be turned.
  for (int i = 0; i <= 8; ++i) colours.setColorAt(i / 8.0, colourOf(1.0 - i / 4.0, theme.dark));
  painter.fillRect(bar, colours);
  const QLocale locale;
  const auto angle = [&](double value) { return tr("%1°").arg(locale.toString(value, 'g', 3)); };
  row = {row.left(), bar.bottom() + 0.1 * line, wide, line};
  painter.drawText(row, Qt::AlignLeft, tr("left %1").arg(angle(fullDegrees())));
  painter.drawText(row, Qt::AlignHCenter, angle(0.0));
  painter.drawText(row, Qt::AlignRight, tr("right %1").arg(angle(fullDegrees())));
}

QString MagneticLayer::textAt(Point place) const {
  if (!map_) return {};
  const locate::MagneticValue value = map_->at(place);
  if (value.known() < kWorthSeeing) return {};
  const QLocale locale;
  const double turned = degrees(Radians{value.deviation});
  const QString size = locale.toString(std::abs(turned), 'f', 1);
  const QString doubt = locale.toString(degrees(Radians{std::sqrt(value.variance)}), 'f', 1);
  const auto visits = static_cast<int>(std::min<std::uint32_t>(value.visits, 1'000'000));
  return (turned < 0.0 ? tr("Iron turns the compass %1° to the right (± %2°, %n visit(s))", "", visits)
                       : tr("Iron turns the compass %1° to the left (± %2°, %n visit(s))", "", visits))
      .arg(size, doubt);
}

}  // namespace tessera::ui
