#include "ui/base/notice.h"

#include <QPainter>

namespace tessera::ui {

Notice::Notice(QWidget* parent) : QLabel{parent} {
  setWordWrap(true);
  setTextFormat(Qt::PlainText);
  setTextInteractionFlags(Qt::TextSelectableByMouse);
  const int edge = fontMetrics().height() / 2;
  setContentsMargins(edge + edge / 2, edge, edge, edge);
  hide();
}

void Notice::show(Tone tone, const QString& sentence) {
  tone_ = tone;
  setText(sentence);
  setVisible(!sentence.isEmpty());
  update();
}

void Notice::clear() { show(Tone::Info, {}); }

QColor Notice::tint() const {
  switch (tone_) {
    case Tone::Info:
      return {0x3b, 0x82, 0xf6};
    case Tone::Good:
      return {0x22, 0xa0, 0x5a};
    case Tone::Warning:
      return {0xe0, 0x9a, 0x10};
    case Tone::Error:
      break;
  }
  return {0xdc, 0x35, 0x45};
}

// A veil over the window's own colour, so that the text keeps the palette's contrast in light and dark.
void Notice::paintEvent(QPaintEvent* event) {
  {
    QPainter painter{this};
    QColor veil = tint();
    painter.fillRect(QRect{0, 0, fontMetrics().height() / 4, height()}, veil);
    veil.setAlphaF(0.16F);
    painter.fillRect(rect(), veil);
  }
  QLabel::paintEvent(event);
}

}  // namespace tessera::ui
