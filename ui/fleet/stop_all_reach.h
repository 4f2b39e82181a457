// A modal dialogue takes the mouse away from every other window, a hanging menu takes the next press for itself:
// neither may stand between the mouse and the button that stops all vehicles.
#pragma once

#include <QObject>
#include <QPointer>

#include "ui/fleet/stop_all.h"

namespace tessera::ui {

/// Lays a button that can be pressed over the one that cannot, for as long as a modal dialogue blocks that one: same
/// place, same looks, same order. It belongs to the dialogue, takes no focus and leaves the keys where they are. A
/// press on either of them that would only close a menu or a list is an order as well.
class StopAllReach : public QObject {
  Q_OBJECT
public:
  StopAllReach(StopAllButton& button, FleetLink& link, QObject* parent);

  [[nodiscard]] bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void settleSoon();
  void settle();
  [[nodiscard]] bool pressesPastPopup(const QEvent& event);

  QPointer<StopAllButton> button_;
  FleetLink& link_;
  QPointer<StopAllButton> standIn_;
  bool settling_ = false;
};

}  // namespace tessera::ui
