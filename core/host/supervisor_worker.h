// What runs on the supervisor's thread: the port's signals and one timer, each leading to one turn of the pump.
#pragma once

#include <QObject>
#include <QTimer>
#include <atomic>

#include "host/serial_port.h"
#include "supervisor/pump.h"

namespace tessera::host {

class SupervisorWorker : public QObject {
  Q_OBJECT
public:
  SupervisorWorker(supervisor::Supervisor supervisor, std::shared_ptr<supervisor::Mailbox> mailbox,
                   SerialPort::Options port);

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
  SerialPort port_;
  QTimer timer_;
  bool ended_ = false;
};

}  // namespace tessera::host
