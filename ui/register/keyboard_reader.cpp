#include "ui/register/keyboard_reader.h"

#include <QCoreApplication>
#include <utility>

namespace tessera::ui {
namespace {

bool isHexDigit(QChar c) {
  return (c >= QLatin1Char{'0'} && c <= QLatin1Char{'9'}) || (c >= QLatin1Char{'a'} && c <= QLatin1Char{'f'}) ||
         (c >= QLatin1Char{'A'} && c <= QLatin1Char{'F'});
}

bool standsBetween(QChar c) { return QStringLiteral(":- @,.+").contains(c); }

}  // namespace

KeyboardReader::KeyboardReader(QObject* parent) : QObject{parent} {
  pause_.setSingleShot(true);
  pause_.setInterval(kPauseMs);
  connect(&pause_, &QTimer::timeout, this, &KeyboardReader::silence);
}

void KeyboardReader::setListening(bool on) {
  if (on == listening_) return;
  listening_ = on;
  if (on) {
    QCoreApplication::instance()->installEventFilter(this);
    return;
  }
  QCoreApplication::instance()->removeEventFilter(this);
  pause_.stop();
  letGo();
}

bool KeyboardReader::takes(const QKeyEvent& key) const {
  const bool plain = (key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
  if (!plain || key.isAutoRepeat() || key.text().size() != 1) return false;
  const QChar c = key.text().front();
  return isHexDigit(c) || (!text_.isEmpty() && standsBetween(c));
}

bool KeyboardReader::ends(const QKeyEvent& key) { return key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter; }

bool KeyboardReader::eventFilter(QObject* watched, QEvent* event) {
  // The window system's own objects see each key before the widget does.
  if (lettingGo_ || !watched->isWidgetType()) return false;
  if (event->type() == QEvent::ShortcutOverride) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (!takes(key) && !(ends(key) && !text_.isEmpty())) return false;
    event->accept();
    return true;
  }
  return event->type() == QEvent::KeyPress && press(watched, static_cast<QKeyEvent&>(*event));
}

bool KeyboardReader::press(QObject* watched, QKeyEvent& key) {
  if (takes(key)) {
    text_ += key.text();
    held_.push_back({watched, std::unique_ptr<QKeyEvent>{key.clone()}});
    pause_.start();
    if (text_.size() > kLongest) letGo();
    return true;
  }
  if (text_.isEmpty()) return false;
  // A reader may hold Shift for capitals: that is no other key.
  if (key.key() == Qt::Key_Shift) return true;
  pause_.stop();
  if (!ends(key) || text_.size() < kShortestLine) {
    letGo();
    return false;
  }
  held_.clear();
  Q_EMIT typed(std::exchange(text_, {}));
  return true;
}

void KeyboardReader::silence() {
  if (text_.size() < kShortest) return letGo();
  // A reader that sends no Enter; nobody types eight digits like that.
  held_.clear();
  Q_EMIT typed(std::exchange(text_, {}));
}

void KeyboardReader::letGo() {
  lettingGo_ = true;
  text_.clear();
  for (const Held& held : std::exchange(held_, {}))
    if (held.target) QCoreApplication::sendEvent(held.target, held.event.get());
  lettingGo_ = false;
}

}  // namespace tessera::ui
