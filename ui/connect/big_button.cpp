#include "ui/connect/big_button.h"

#include <QEvent>
#include <QKeySequence>
#include <QPainter>
#include <QStyleOptionButton>
#include <QStylePainter>
#include <algorithm>

#include "ui/base/icon.h"

namespace tessera::ui {

BigButton::BigButton(const QString& iconName, QWidget* parent) : QPushButton{parent}, icon_{ui::icon(iconName)} {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  setAutoDefault(true);
}

// The text proper stays empty, as the style would draw it in the middle; the mnemonic is set by hand.
void BigButton::setTexts(const QString& title, const QString& description) {
  title_ = title;
  description_ = description;
  setShortcut(QKeySequence::mnemonic(title));
  QString plain = title;
  setAccessibleName(plain.remove(QLatin1Char('&')));
  setAccessibleDescription(description);
  updateGeometry();
  update();
}

QFont BigButton::titleFont() const {
  QFont f = font();
  f.setPointSizeF(f.pointSizeF() * 1.25);
  f.setBold(true);
  return f;
}

int BigButton::iconSide() const { return fontMetrics().height() * 2; }
int BigButton::gap() const { return fontMetrics().height() * 2 / 3; }

QSize BigButton::sizeHint() const {
  const QFontMetrics title{titleFont()};
  const int text = std::max(title.size(Qt::TextShowMnemonic, title_).width(),
                            fontMetrics().size(Qt::TextSingleLine, description_).width());
  return {gap() * 3 + iconSide() + text, gap() * 2 + title.height() + fontMetrics().height()};
}

void BigButton::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange) updateGeometry();
  QPushButton::changeEvent(event);
}

void BigButton::paintEvent(QPaintEvent* /*event*/) {
  QStylePainter painter{this};
  QStyleOptionButton option;
  initStyleOption(&option);
  option.features &= ~QStyleOptionButton::DefaultButton;
  painter.drawControl(QStyle::CE_PushButtonBevel, option);
  const QRect inside = rect().adjusted(gap(), gap(), -gap(), -gap());
  const QRect picture =
      QStyle::alignedRect(layoutDirection(), Qt::AlignLeft | Qt::AlignVCenter, QSize{iconSide(), iconSide()}, inside);
  icon_.paint(&painter, picture, Qt::AlignCenter, isEnabled() ? QIcon::Normal : QIcon::Disabled);

  QRect text = inside.adjusted(iconSide() + gap(), 0, 0, 0);
  painter.setPen(palette().color(QPalette::ButtonText));
  painter.setFont(titleFont());
  const int titleHeight = QFontMetrics{titleFont()}.height();
  painter.drawText(QRect{text.topLeft(), QSize{text.width(), titleHeight}},
                   Qt::AlignLeft | Qt::TextShowMnemonic | Qt::TextDontClip, title_);
  painter.setFont(font());
  text.setTop(text.top() + titleHeight);
  // Fonts that stand in for missing characters may reach below the line.
  painter.drawText(text, Qt::AlignLeft | Qt::TextSingleLine | Qt::TextDontClip,
                   fontMetrics().elidedText(description_, Qt::ElideRight, text.width()));
  if (option.state.testFlag(QStyle::State_HasFocus)) {
    QStyleOptionFocusRect focus;
    focus.initFrom(this);
    focus.rect = rect().adjusted(3, 3, -3, -3);
    painter.drawPrimitive(QStyle::PE_FrameFocusRect, focus);
  }
}

}  // namespace tessera::ui
