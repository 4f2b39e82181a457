#include "ui/connect/jumper_picture.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>

namespace tessera::ui {

JumperPicture::JumperPicture(Jumpers jumpers, QWidget* parent) : QWidget{parent}, jumpers_{jumpers} {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  retranslate();
}

QSize JumperPicture::sizeHint() const {
  const int line = fontMetrics().height();
  return {std::max(line * 11, fontMetrics().horizontalAdvance(caption_) + line), line * 8};
}

// The drawing's unit is half a line of text: board, antenna socket, two pairs of pins, and caps over them.
void JumperPicture::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter{this};
  painter.setRenderHint(QPainter::Antialiasing);
  const double u = fontMetrics().height() / 2.0;
  const QColor ink = palette().color(QPalette::WindowText);
  const double left = (width() - 19 * u) / 2;
  QColor board{0x2f, 0x8f, 0x5b};
  board.setAlphaF(0.35F);
  painter.setPen(QPen{ink, u * 0.16});
  painter.setBrush(board);
  const QRectF plate{left + 0.5 * u, 1.5 * u, 15 * u, 10 * u};
  painter.drawRoundedRect(plate, u * 0.6, u * 0.6);
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF{plate.right(), plate.top() + 1.2 * u, 2.4 * u, 1.6 * u});  // antenna socket
  painter.drawRect(QRectF{plate.left() + 1.2 * u, plate.top() + 1.2 * u, 5.6 * u, 7.4 * u});
  painter.drawText(QRectF{plate.left() + 1.2 * u, plate.top() + 1.2 * u, 5.6 * u, 7.4 * u}, Qt::AlignCenter,
                   QStringLiteral("E32"));

  for (int i = 0; i < 2; ++i) {
    const double x = plate.left() + (8.0 + 3.6 * i) * u;
    const double y = plate.top() + 4.2 * u;
    const QRectF cap{x, y, 2.4 * u, 4.4 * u};
    painter.drawText(QRectF{x - u, y - 2.4 * u, 4.4 * u, 2.2 * u}, Qt::AlignCenter,
                     i == 0 ? QStringLiteral("M0") : QStringLiteral("M1"));
    painter.setBrush(jumpers_ == Jumpers::On ? QColor{0xe0, 0x9a, 0x10} : QColor{Qt::transparent});
    painter.setPen(QPen{ink, u * 0.16, jumpers_ == Jumpers::On ? Qt::SolidLine : Qt::DotLine});
    painter.drawRoundedRect(cap, u * 0.4, u * 0.4);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    for (const double down : {1.2, 3.2}) painter.drawEllipse(QPointF{x + 1.2 * u, y + down * u}, 0.5 * u, 0.5 * u);
    painter.setPen(QPen{ink, u * 0.16});
    painter.setBrush(Qt::NoBrush);
  }
  painter.drawText(QRectF{0, plate.bottom() + 0.8 * u, double(width()), 2.4 * u}, Qt::AlignCenter, caption_);
}

void JumperPicture::retranslate() {
  caption_ = jumpers_ == Jumpers::Off ? tr("Both off: settings") : tr("Both on: service");
  setAccessibleName(jumpers_ == Jumpers::Off ? tr("Picture: the jumpers M0 and M1 are taken off")
                                             : tr("Picture: the jumpers M0 and M1 are in place"));
  updateGeometry();
  update();
}

void JumperPicture::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
