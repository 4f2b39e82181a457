#include "ui/fleet/vehicle_delegate.h"

#include <QApplication>
#include <QPainter>

#include "ui/fleet/roles.h"
#include "ui/fleet/tone.h"

namespace tessera::ui {
namespace {

int iconSide(const QStyleOptionViewItem& option) { return option.fontMetrics.height(); }

bool isLit(const QStyleOptionViewItem& option) { return option.state.testFlag(QStyle::State_Selected); }

QColor inkOf(const QStyleOptionViewItem& option, Tone tone) {
  return isLit(option) ? option.palette.color(QPalette::HighlightedText) : toneColour(tone, option.palette);
}

}  // namespace

void VehicleDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  const Tone tone = static_cast<Tone>(index.data(ToneRole).toInt());
  const QColor ink = inkOf(*option, tone);
  if (tone != Tone::Plain) option->palette.setColor(QPalette::Text, ink);
  const qreal ratio = option->widget == nullptr ? 1.0 : option->widget->devicePixelRatioF();
  const int side = iconSide(*option);
  if (const QVariant dot = index.data(DotRole); dot.isValid()) {
    const QColor rim = isLit(*option) ? option->palette.color(QPalette::HighlightedText) : dot.value<QColor>();
    option->icon = dotIcon(dot.value<QColor>(), rim, side, ratio);
  } else if (const QString name = index.data(IconRole).toString(); !name.isEmpty()) {
    option->icon = tintedIcon(name, ink, side, ratio);
  } else {
    return;
  }
  option->features |= QStyleOptionViewItem::HasDecoration;
  option->decorationSize = {side, side};
}

void VehicleDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const QVariant permille = index.data(PermilleRole);
  if (!permille.isValid()) return QStyledItemDelegate::paint(painter, option, index);
  QStyleOptionViewItem cell = option;
  initStyleOption(&cell, index);
  const QStyle* style = cell.widget == nullptr ? QApplication::style() : cell.widget->style();
  style->drawPrimitive(QStyle::PE_PanelItemViewItem, &cell, painter, cell.widget);

  const int gap = cell.fontMetrics.height() / 3;
  const QRect inside = cell.rect.adjusted(gap, 0, -gap, 0);
  const int textWidth = cell.fontMetrics.horizontalAdvance(QStringLiteral("100 %")) + gap;
  const QColor ink = inkOf(cell, Tone::Plain);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(ink);
  painter->drawText(inside, Qt::AlignRight | Qt::AlignVCenter, cell.text);
  QRectF bar = inside.adjusted(0, 0, -textWidth, 0);
  if (bar.width() > gap) {
    const qreal height = cell.fontMetrics.height() / 2.5;
    bar = QRectF{bar.left(), bar.center().y() - height / 2, bar.width(), height};
    QColor groove = ink;
    groove.setAlphaF(0.2F);
    painter->setPen(Qt::NoPen);
    painter->setBrush(groove);
    painter->drawRoundedRect(bar, height / 2, height / 2);
    painter->setBrush(isLit(cell) ? ink : toneColour(Tone::Busy, cell.palette));
    painter->setClipRect(QRectF{bar.left(), bar.top(), bar.width() * permille.toInt() / 1000.0, bar.height()});
    painter->drawRoundedRect(bar, height / 2, height / 2);
  }
  painter->restore();
}

QSize VehicleDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QSize size = QStyledItemDelegate::sizeHint(option, index);
  size.setHeight(std::max(size.height(), option.fontMetrics.height() * 8 / 5));
  return size;
}

}  // namespace tessera::ui
