// What runs on the supervisor's thread: the port's signals and one timer, each leading to one turn of the pump.
#pragma once

#include <QObject>
#include <QTimer>
#include <atomic>

#include "host/port_choice.h"
#include "supervisor/pump.h"

namespace tessera::host {

class SupervisorWorker : public QObject {
  Q_OBJECT
public:
  SupervisorWorker(supervisor::Supervisor supervisor, std::shared_ptr<supervisor::Mailbox> mailbox,
                   const PortChoice& port);

  void start();
  /// Stops the vehicles; closed() follows when they stand, or after `patience`.
  void close(std::chrono::milliseconds patience);
  /// One turn now: an order was posted.
  void turn();

signals:
  void newSnapshot();
  void newEvents();
  void closed(bool allStood);

private:
  supervisor::Pump pump_;
  std::unique_ptr<BytePort> port_;  ///< a child as well, so that it follows to the thread
  QTimer timer_;
  bool ended_ = false;
};

}  // namespace tessera::host
