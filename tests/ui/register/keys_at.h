// Keys as the window system brings them: each with its own time, whenever they come here.
#pragma once

#include <QCoreApplication>
#include <QKeyEvent>
#include <QWidget>

namespace tessera::test {

/// The first at `ms`, the others a millisecond after each other.
inline void keysAt(QWidget& field, const char* keys, quint64 ms) {
  for (const char* c = keys; *c != 0; ++c) {
    const QChar key = QLatin1Char{*c};
    QKeyEvent event{QEvent::KeyPress, key.toUpper().unicode(), Qt::NoModifier, QString{key}};
    event.setTimestamp(ms++);
    QCoreApplication::sendEvent(&field, &event);
  }
}

}  // namespace tessera::test
