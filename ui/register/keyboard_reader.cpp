#include "ui/register/keyboard_reader.h"

#include <QCoreApplication>
#include <utility>

namespace tessera::ui {
namespace {

bool isHexDigit(QChar c) {
  return (c >= QLatin1Char{'0'} && c <= QLatin1Char{'9'}) || (c >= QLatin1Char{'a'} && c <= QLatin1Char{'f'}) ||
         (c >= QLatin1Char{'A'} && c <= QLatin1Char{'F'});
}

// A pause is counted in turns of the event loop: a program that stalls loses one, and the keys that waited meanwhile
// come before the next.
constexpr int kTurnMs = 40;

bool standsBetween(QChar c) { return QStringLiteral(":- @,.+").contains(c); }

}  // namespace

KeyboardReader::KeyboardReader(QObject* parent) : QObject{parent} {
  pause_.setInterval(kTurnMs);
  connect(&pause_, &QTimer::timeout, this, &KeyboardReader::turn);
}

void KeyboardReader::setListening(bool on) {
  if (on == listening_) return;
  listening_ = on;
  sendsEnter_ = false;
  before_ = Before::Nothing;
  if (on) {
    QCoreApplication::instance()->installEventFilter(this);
    return;
  }
  QCoreApplication::instance()->removeEventFilter(this);
  letGo();
}

bool KeyboardReader::takes(const QKeyEvent& key) const {
  const bool plain = (key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
  if (!plain || key.isAutoRepeat() || key.text().size() != 1) return false;
  const QChar c = key.text().front();
  return isHexDigit(c) || (!text_.isEmpty() && standsBetween(c));
}

bool KeyboardReader::ends(const QKeyEvent& key) { return key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter; }

bool KeyboardReader::soon(const QKeyEvent& key) const {
  if (stamp_ != 0 && key.timestamp() >= stamp_) return key.timestamp() - stamp_ <= quint64{kRestMs};
  return since_.isValid() && since_.elapsed() <= kRestMs;
}

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
    // Keys that waited in a queue come all at once; their own times tell where a silence was.
    if (!text_.isEmpty() && stamp_ != 0 && key.timestamp() > stamp_ + static_cast<quint64>(longestPause())) silence();
    if (text_.isEmpty()) rest_ = before_ != Before::Nothing && soon(key);
    text_ += key.text();
    held_.push_back({watched, std::unique_ptr<QKeyEvent>{key.clone()}});
    stamp_ = key.timestamp();
    since_.start();
    turns_ = 0;
    pause_.start();
    if (text_.size() > kLongest) letGo();
    return true;
  }
  if (text_.isEmpty()) {
    // The Enter of a read that a silence ended presses nothing.
    if (!ends(key) || before_ == Before::Nothing || before_ == Before::Keys || !soon(key)) return false;
    sendsEnter_ = sendsEnter_ || before_ == Before::Piece;
    before_ = Before::Nothing;
    return true;
  }
  // A reader may hold Shift for capitals: that is no other key.
  if (key.key() == Qt::Key_Shift) return true;
  const bool restOfRead = rest_ && before_ != Before::Keys;
  if (!ends(key) || (text_.size() < kShortestLine && !restOfRead)) {
    letGo();
    return false;
  }
  enter();
  return true;
}

void KeyboardReader::turn() {
  if (++turns_ * kTurnMs >= longestPause()) silence();
}

void KeyboardReader::enter() {
  sendsEnter_ = true;
  // What was told without Enter was a piece, as this reader sends it; and the piece's line ends here.
  const bool whole = before_ == Before::Nothing || (before_ == Before::Keys && !rest_);
  const QString line = text_;
  if (!whole) {
    tear();
  } else {
    drop();
  }
  before_ = Before::Nothing;
  if (whole) Q_EMIT typed(line);
}

void KeyboardReader::silence() {
  const bool enough = text_.size() >= kShortest;
  // Another card's UID is as long as the one before.
  const bool another = enough && before_ == Before::Read && text_.size() == told_.size();
  if (rest_ && !another && (enough || before_ != Before::Keys)) return tear();
  if (!enough) {
    letGo();
    if (before_ != Before::Piece) before_ = Before::Keys;
    return;
  }
  if (sendsEnter_) return tear();
  before_ = Before::Read;
  told_ = text_;
  drop();
  Q_EMIT typed(told_);
}

void KeyboardReader::tear() {
  const bool saidAlready = rest_ && before_ == Before::Piece;
  const bool wasTyped = before_ == Before::Read;
  const QString piece = wasTyped ? told_ : text_;
  drop();
  before_ = Before::Piece;
  if (!saidAlready) Q_EMIT torn(piece, wasTyped);
}

void KeyboardReader::drop() {
  pause_.stop();
  text_.clear();
  held_.clear();
}

void KeyboardReader::letGo() {
  lettingGo_ = true;
  pause_.stop();
  text_.clear();
  for (const Held& held : std::exchange(held_, {}))
    if (held.target) QCoreApplication::sendEvent(held.target, held.event.get());
  lettingGo_ = false;
}

}  // namespace tessera::ui
