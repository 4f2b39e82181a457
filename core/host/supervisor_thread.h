// The supervisor on a thread of its own, with the port and the clock. Others post orders and read snapshots and events;
// they share no lock with it. Closing stops the vehicles first and joins within a bound.
#pragma once

#include <QObject>
#include <QThread>
#include <atomic>
#include <memory>

#include "host/port_choice.h"
#include "supervisor/mailbox.h"
#include "supervisor/supervisor.h"

namespace tessera::host {

/// Seconds of CLOCK_MONOTONIC, the clock of snapshots and events in a real run.
[[nodiscard]] Seconds steadyNow();

class SupervisorWorker;

class SupervisorThread : public QObject {
  Q_OBJECT
public:
  SupervisorThread(supervisor::Supervisor supervisor, const PortChoice& port, QObject* parent = nullptr);
  /// Closes, if that has not been done.
  ~SupervisorThread() override;

  void start();
  /// Orders every vehicle to stop, waits until they stand or `patience` is over, closes the port and joins the thread.
  /// True: they all stood.
  bool close(std::chrono::milliseconds patience = std::chrono::milliseconds{2000});

  /// From any thread. False: too many orders wait, or it is closed.
  bool post(supervisor::Order order);
  /// From any thread; null before the first.
  [[nodiscard]] std::shared_ptr<const supervisor::Snapshot> latest() const { return mailbox_->latest(); }
  /// From any thread: the events since the last call, oldest first.
  [[nodiscard]] std::vector<supervisor::Event> takeEvents() { return mailbox_->takeEvents(); }
  [[nodiscard]] const std::shared_ptr<supervisor::Mailbox>& mailbox() const { return mailbox_; }

signals:
  /// There is a newer snapshot. At most one of these waits in a receiver's queue.
  void snapshotChanged();
  void eventsArrived();

private:
  void tell(std::atomic<bool>& waiting, void (SupervisorThread::*signal)());

  std::shared_ptr<supervisor::Mailbox> mailbox_;
  QThread thread_;
  std::unique_ptr<SupervisorWorker> worker_;  // its events run on thread_; deleted after that has been joined
  std::atomic<bool> snapshotTold_{false};
  std::atomic<bool> eventsTold_{false};
  std::atomic<bool> orderTold_{false};
  std::atomic<bool> allStood_{false};
  std::atomic<bool> closed_{false};
  bool started_ = false;
};

}  // namespace tessera::host
