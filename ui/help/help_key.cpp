#include "ui/help/help_key.h"

#include <QCoreApplication>
#include <QKeyEvent>

namespace tessera::ui {

HelpKey::HelpKey(QObject* parent) : QObject{parent} { QCoreApplication::instance()->installEventFilter(this); }

// Accepted as an override first, so that it comes as a key and not as the menu's shortcut.
bool HelpKey::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride)
    return QObject::eventFilter(watched, event);
  const auto* key = dynamic_cast<QKeyEvent*>(event);
  if (key == nullptr || key->key() != kKey || key->modifiers() != Qt::NoModifier)
    return QObject::eventFilter(watched, event);
  event->accept();
  if (event->type() == QEvent::KeyPress && !key->isAutoRepeat()) Q_EMIT pressed();
  return true;
}

}  // namespace tessera::ui
