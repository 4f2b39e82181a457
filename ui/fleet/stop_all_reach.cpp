#include "ui/fleet/stop_all_reach.h"

#include <QApplication>
#include <QEvent>
#include <QMouseEvent>

namespace tessera::ui {
namespace {

// A dialogue of the dialogue: Qt blocks neither it nor anything else that belongs to the foremost modal window, and the
// window manager keeps it above. Where programs may not place their windows (Wayland) only what pops up has a place.
Qt::WindowFlags standInFlags() {
  const bool placed = !QGuiApplication::platformName().startsWith(QLatin1String{"wayland"});
  return (placed ? Qt::Dialog : Qt::ToolTip) | Qt::FramelessWindowHint | Qt::WindowDoesNotAcceptFocus |
         Qt::NoDropShadowWindowHint;
}

}  // namespace

StopAllReach::StopAllReach(StopAllButton& button, FleetLink& link, QObject* parent)
    : QObject{parent}, button_{&button}, link_{link} {
  QCoreApplication::instance()->installEventFilter(this);
}

// Whenever a modal dialogue comes or goes, some window is blocked or free again.
bool StopAllReach::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::WindowBlocked:
    case QEvent::WindowUnblocked:
      settleSoon();
      break;
    case QEvent::Move:
    case QEvent::Resize:
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::WindowStateChange:
      if (button_ != nullptr && (watched == button_.data() || watched == button_->window())) settleSoon();
      break;
    case QEvent::WindowActivate:
      if (standIn_ == nullptr) break;
      // A dialogue that is activated may have been put above what belongs to it.
      if (watched == standIn_->parentWidget()) settleSoon();
      // Some window systems activate whatever comes up.
      if (watched == standIn_.data()) {
        QMetaObject::invokeMethod(
            standIn_->parentWidget(), [modal = standIn_->parentWidget()] { modal->activateWindow(); },
            Qt::QueuedConnection);
      }
      break;
    case QEvent::MouseButtonPress:
      if (pressesPastPopup(*event)) return true;
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

bool StopAllReach::pressesPastPopup(const QEvent& event) {
  if (QApplication::activePopupWidget() == nullptr) return false;
  const auto* press = dynamic_cast<const QMouseEvent*>(&event);
  QWidget* hit = press != nullptr ? QApplication::widgetAt(press->globalPosition().toPoint()) : nullptr;
  StopAllButton* pressed = hit == button_.data() ? button_.data() : hit == standIn_.data() ? standIn_.data() : nullptr;
  if (pressed == nullptr) return false;
  // The order first: nothing that a menu does when it closes comes before it.
  pressed->animateClick();
  while (QWidget* popup = QApplication::activePopupWidget())
    if (!popup->close()) break;
  return true;
}

// Not within the event: the dialogue is not on the screen yet, or is just being destroyed.
void StopAllReach::settleSoon() {
  if (settling_) return;
  settling_ = true;
  QMetaObject::invokeMethod(this, &StopAllReach::settle, Qt::QueuedConnection);
}

void StopAllReach::settle() {
  settling_ = false;
  QWidget* modal = QApplication::activeModalWidget();
  const bool needed = modal != nullptr && modal->isVisible() && button_ != nullptr && button_->isVisible() &&
                      !button_->window()->isMinimized() && !modal->isAncestorOf(button_);
  if (standIn_ != nullptr && (!needed || standIn_->parentWidget() != modal)) {
    standIn_->hide();
    standIn_->deleteLater();  // it may be the one that is just being pressed
    standIn_ = nullptr;
  }
  if (!needed) return;
  if (standIn_ == nullptr) {
    standIn_ = new StopAllButton{link_, modal};
    standIn_->setObjectName(QStringLiteral("stopAllStandIn"));
    standIn_->setWindowFlags(standInFlags());
    standIn_->setAttribute(Qt::WA_ShowWithoutActivating);
    standIn_->setFocusPolicy(Qt::NoFocus);
    connect(standIn_, &StopAllButton::ordered, button_, &StopAllButton::ordered);
  }
  standIn_->setFont(button_->font());
  standIn_->setGeometry(QRect{button_->mapToGlobal(QPoint{}), button_->size()});
  standIn_->show();
  standIn_->raise();  // window managers may put what takes no focus beneath what has it
}

}  // namespace tessera::ui
