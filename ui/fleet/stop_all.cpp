#include "ui/fleet/stop_all.h"

#include <QCoreApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QKeySequence>
#include <QPainter>
#include <QToolTip>

#include "ui/fleet/tone.h"

namespace tessera::ui {

StopAllButton::StopAllButton(FleetLink& link, QWidget* parent) : QAbstractButton{parent}, link_{link} {
  setObjectName(QStringLiteral("stopAllButton"));
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
  setCursor(Qt::PointingHandCursor);
  connect(this, &QAbstractButton::pressed, this, [this] {
    const bool taken = link_.post(supervisor::StopAll{});
    if (!taken)
      QToolTip::showText(mapToGlobal(rect().bottomLeft()), tr("Not connected: there is nobody to stop."), this);
    Q_EMIT ordered(taken);
  });
  retranslate();
}

void StopAllButton::retranslate() {
  setText(tr("Stop all"));
  setAccessibleName(text());
  setAccessibleDescription(tr("Stops every vehicle at once. Nothing moves again without a new order."));
  setToolTip(
      tr("Stops every vehicle at once. Nothing moves again without a new order. The key %1 does the same, from any "
         "window of the program.")
          .arg(QKeySequence{StopAllKey::kKey}.toString(QKeySequence::NativeText)));
  updateGeometry();
  update();
}

void StopAllButton::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  if (event->type() == QEvent::FontChange) updateGeometry();
  QAbstractButton::changeEvent(event);
}

QFont StopAllButton::labelFont() const {
  QFont label = font();
  label.setBold(true);
  label.setPointSizeF(label.pointSizeF() * 1.2);
  return label;
}

QSize StopAllButton::sizeHint() const {
  const QFontMetrics label{labelFont()};
  const int key = fontMetrics().horizontalAdvance(QKeySequence{StopAllKey::kKey}.toString(QKeySequence::NativeText));
  const int gap = label.height() / 2;
  return {label.horizontalAdvance(text()) + label.height() * 5 / 4 + key + 6 * gap, label.height() * 2};
}

// Its own drawing: styles do not let a button be red in every theme, and this one must never look like the others.
void StopAllButton::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter{this};
  painter.setRenderHint(QPainter::Antialiasing);
  const QFontMetrics metrics{labelFont()};
  const int gap = metrics.height() / 2;
  const QRectF face = QRectF{rect()}.adjusted(1, 1, -1, -1);
  const QColor red = isDown()       ? QColor{0x8E, 0x16, 0x16}
                     : underMouse() ? QColor{0xD8, 0x35, 0x35}
                                    : QColor{0xC6, 0x28, 0x28};
  painter.setPen(QPen{QColor{0x7A, 0x10, 0x10}, 1});
  painter.setBrush(red);
  painter.drawRoundedRect(face, gap / 2.0, gap / 2.0);

  const int side = metrics.height() * 5 / 4;
  const QRect inside = rect().adjusted(gap, 0, -gap, 0);
  const QRect sign{inside.left(), inside.center().y() - side / 2, side, side};
  tintedIcon(QStringLiteral("stop-all"), Qt::white, side, devicePixelRatioF()).paint(&painter, sign);
  painter.setPen(Qt::white);
  painter.setFont(labelFont());
  painter.drawText(inside.adjusted(side + gap, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text());

  const QString key = QKeySequence{StopAllKey::kKey}.toString(QKeySequence::NativeText);
  painter.setFont(font());
  const int width = fontMetrics().horizontalAdvance(key) + gap;
  const int height = fontMetrics().height() + gap / 3;
  const QRectF cap{inside.right() - width + 0.5, (rect().height() - height) / 2.0, static_cast<qreal>(width),
                   static_cast<qreal>(height)};
  painter.setPen(QPen{QColor{255, 255, 255, 170}, 1});
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(cap, 3, 3);
  painter.setPen(Qt::white);
  painter.drawText(cap, Qt::AlignCenter, key);
  if (hasFocus()) {
    painter.setPen(QPen{Qt::white, 1.5, Qt::DotLine});
    painter.drawRoundedRect(face.adjusted(2.5, 2.5, -2.5, -2.5), gap / 3.0, gap / 3.0);
  }
}

StopAllKey::StopAllKey(FleetLink& link, QObject* parent) : QObject{parent}, link_{link} {
  QCoreApplication::instance()->installEventFilter(this);
}

// The application's filter sees the key before any window, modal dialogue, menu or shortcut does, and keeps it.
bool StopAllKey::eventFilter(QObject* watched, QEvent* event) {
  const bool press = event->type() == QEvent::KeyPress;
  if (!press && event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyRelease)
    return QObject::eventFilter(watched, event);
  const auto* key = dynamic_cast<QKeyEvent*>(event);
  if (key == nullptr || key->key() != kKey) return QObject::eventFilter(watched, event);
  event->accept();
  if (press && !key->isAutoRepeat()) Q_EMIT ordered(link_.post(supervisor::StopAll{}));
  return true;
}

}  // namespace tessera::ui
