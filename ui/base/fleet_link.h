// The window's only way to the vehicles: pictures of the fleet and events come in, orders go out. The program gives it
// an implementation over the supervisor's thread; tests give it values.
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "supervisor/event.h"
#include "supervisor/order.h"
#include "supervisor/snapshot.h"

namespace tessera::ui {

class FleetLink : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;

  /// The newest picture; null while no supervision runs.
  [[nodiscard]] virtual std::shared_ptr<const supervisor::Snapshot> latest() const = 0;
  /// False: no supervision runs, or it takes no more orders. What becomes of an order that was taken is told by events.
  virtual bool post(supervisor::Order order) = 0;

Q_SIGNALS:
  /// latest() differs from what it was.
  void snapshotChanged();
  /// Oldest first, each event once.
  void eventsArrived(const std::vector<tessera::supervisor::Event>& events);
};

}  // namespace tessera::ui
