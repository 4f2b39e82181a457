#include "ui/lay/type_picture.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/canvas/theme.h"

namespace tessera::ui {
namespace {

constexpr double kNeighbour = 0.45;  // as much of the tiles beside it is shown

QString centimetres(Metres length) {
  return TypePicture::tr("%1 cm").arg(QLocale().toString(std::round(length.value() * 1e4) / 100.0));
}

}  // namespace

TypePicture::TypePicture(QWidget* parent) : QWidget{parent} {
  setObjectName("typePicture");
  setFocusPolicy(Qt::StrongFocus);
  retranslate();
}

void TypePicture::retranslate() {
  setAccessibleName(tr("Drawing of the tile type"));
  setToolTip(tr("Click a place to put a tag there or to take it away; with the keys: arrows and space bar."));
}

void TypePicture::setType(const floor::TileType& type) {
  type_ = type;
  column_ = std::clamp(column_, 0, std::max(0, type.columns - 1));
  row_ = std::clamp(row_, 0, std::max(0, type.rows - 1));
  right_ = floor::seamOf(type, floor::Side::Right);
  above_ = floor::seamOf(type, floor::Side::Above);
  update();
}

double TypePicture::scale() const {
  const double band = fontMetrics().height() * 1.6;
  const double w = std::max(type_.width.value(), 1e-3) * (1.0 + kNeighbour);
  const double h = std::max(type_.height.value(), 1e-3) * (1.0 + kNeighbour);
  return std::max(1e-3, std::min((width() - band - 4) / w, (height() - band - 4) / h));
}

QPointF TypePicture::toPixel(Offset place) const {
  const double band = fontMetrics().height() * 1.6;
  return {band + place.x.value() * scale(), height() - band - place.y.value() * scale()};
}

QPointF TypePicture::pixelOf(int column, int row) const {
  return toPixel(type_.margin + Offset{column * type_.pitch, row * type_.pitch});
}

void TypePicture::paintTile(QPainter& painter, Offset corner, bool neighbour) const {
  const CanvasTheme theme{palette()};
  const QRectF box{toPixel(corner + Offset{{}, type_.height}), toPixel(corner + Offset{type_.width, {}})};
  painter.setPen(QPen{theme.seam, neighbour ? 1.0 : 2.0});
  painter.setBrush(theme.tile);
  painter.drawRect(box);
  const double radius = std::clamp(type_.pitch.value() * scale() * 0.16, 1.0, 7.0);
  for (int row = 0; row < type_.rows; ++row) {
    for (int column = 0; column < type_.columns; ++column) {
      const QPointF at = toPixel(corner + type_.margin + Offset{column * type_.pitch, row * type_.pitch});
      if (!rect().contains(at.toPoint())) continue;
      const bool tag = floor::hasTag(type_, column, row);
      painter.setPen(tag ? QPen{Qt::NoPen} : QPen{theme.missingTag, 1.0});
      painter.setBrush(tag ? QBrush{theme.tag} : QBrush{Qt::NoBrush});
      painter.drawEllipse(at, tag ? radius : radius * 0.7, tag ? radius : radius * 0.7);
    }
  }
}

void TypePicture::paintEvent(QPaintEvent* /*event*/) {
  const CanvasTheme theme{palette()};
  QPainter painter{this};
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), theme.background);
  if (!(type_.width > Metres{}) || !(type_.height > Metres{})) return;
  const double band = fontMetrics().height() * 1.6;
  const Offset right{type_.width, {}};
  const Offset above{{}, type_.height};
  painter.save();
  painter.setClipRect(QRectF{band - 2, toPixel(above + kNeighbour * above).y(),
                             toPixel(right + kNeighbour * right).x() - band + 2, double(height())});
  for (const Offset corner : {right + above, right, above}) {
    painter.setOpacity(0.5);
    paintTile(painter, corner, true);
  }
  painter.setOpacity(1.0);
  paintTile(painter, {}, false);
  painter.setPen(QPen{theme.fault, 2.5});
  for (const floor::Seam* seam : {&right_, &above_}) {
    for (const auto& [here, there] : seam->meeting) painter.drawLine(toPixel(here), toPixel(there));
  }
  if (hasFocus()) {
    const double ring = std::clamp(type_.pitch.value() * scale() * 0.3, 4.0, 12.0);
    painter.setPen(QPen{theme.accent, 2.0});
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(pixelOf(column_, row_), ring, ring);
  }
  painter.restore();
  painter.setPen(theme.text);
  const QPointF low = toPixel({});
  painter.drawText(QRectF{low.x(), low.y() + 2, type_.width.value() * scale(), band}, Qt::AlignHCenter | Qt::AlignTop,
                   centimetres(type_.width));
  painter.translate(low.x() - 4, low.y());
  painter.rotate(-90);
  painter.drawText(QRectF{0, -band, type_.height.value() * scale(), band}, Qt::AlignHCenter | Qt::AlignBottom,
                   centimetres(type_.height));
}

void TypePicture::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || type_.columns < 1 || type_.rows < 1) return;
  const QPointF first = pixelOf(0, 0);
  const double pitch = type_.pitch.value() * scale();
  const auto column = static_cast<int>(std::lround((event->position().x() - first.x()) / pitch));
  const auto row = static_cast<int>(std::lround((first.y() - event->position().y()) / pitch));
  if (column < 0 || row < 0 || column >= type_.columns || row >= type_.rows) return;
  column_ = column;
  row_ = row;
  Q_EMIT placeToggled(column, row);
  update();
}

void TypePicture::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      column_ = std::max(0, column_ - 1);
      break;
    case Qt::Key_Right:
      column_ = std::min(std::max(0, type_.columns - 1), column_ + 1);
      break;
    case Qt::Key_Down:
      row_ = std::max(0, row_ - 1);
      break;
    case Qt::Key_Up:
      row_ = std::min(std::max(0, type_.rows - 1), row_ + 1);
      break;
    case Qt::Key_Space:
      Q_EMIT placeToggled(column_, row_);
      break;
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  update();
}

void TypePicture::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
