#include "host/supervisor_thread.h"

#include <chrono>

#include "host/supervisor_worker.h"

namespace tessera::host {

Seconds steadyNow() {
  return Seconds{std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count()};
}

SupervisorThread::SupervisorThread(supervisor::Supervisor supervisor, const PortChoice& port, QObject* parent)
    : QObject{parent},
      mailbox_{std::make_shared<supervisor::Mailbox>()},
      worker_{std::make_unique<SupervisorWorker>(std::move(supervisor), mailbox_, port)} {
  thread_.setObjectName(QStringLiteral("supervisor"));
  worker_->moveToThread(&thread_);
  const auto direct = Qt::DirectConnection;
  connect(
      worker_.get(), &SupervisorWorker::newSnapshot, this,
      [this] { tell(snapshotTold_, &SupervisorThread::snapshotChanged); }, direct);
  connect(
      worker_.get(), &SupervisorWorker::newEvents, this,
      [this] { tell(eventsTold_, &SupervisorThread::eventsArrived); }, direct);
  connect(
      worker_.get(), &SupervisorWorker::closed, this,
      [this](bool allStood) {
        allStood_ = allStood;
        thread_.quit();
      },
      direct);
}

SupervisorThread::~SupervisorThread() { close(); }

// Called on the supervisor's thread; the signal is emitted on this object's. A receiver that is slow gets one signal,
// not a queue of them.
void SupervisorThread::tell(std::atomic<bool>& waiting, void (SupervisorThread::*signal)()) {
  if (waiting.exchange(true)) return;
  QMetaObject::invokeMethod(
      this,
      [this, &waiting, signal] {
        waiting = false;
        emit(this->*signal)();
      },
      Qt::QueuedConnection);
}

void SupervisorThread::start() {
  if (started_ || closed_) return;
  started_ = true;
  thread_.start(QThread::HighPriority);
  QMetaObject::invokeMethod(worker_.get(), &SupervisorWorker::start, Qt::QueuedConnection);
}

bool SupervisorThread::post(supervisor::Order order) {
  if (closed_ || !mailbox_->post(std::move(order))) return false;
  if (!orderTold_.exchange(true))
    QMetaObject::invokeMethod(
        worker_.get(),
        [this] {
          orderTold_ = false;
          worker_->turn();
        },
        Qt::QueuedConnection);
  return true;
}

bool SupervisorThread::close(std::chrono::milliseconds patience) {
  if (closed_.exchange(true) || !started_) return allStood_;
  QMetaObject::invokeMethod(
      worker_.get(), [worker = worker_.get(), patience] { worker->close(patience); }, Qt::QueuedConnection);
  // The worker never blocks, so it ends within its patience; the thread is never terminated by force.
  thread_.wait();
  return allStood_;
}

}  // namespace tessera::host
