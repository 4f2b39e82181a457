#include "host/supervisor_worker.h"

#include <algorithm>
#include <cmath>

#include "host/supervisor_thread.h"

namespace tessera::host {

SupervisorWorker::SupervisorWorker(supervisor::Supervisor supervisor, std::shared_ptr<supervisor::Mailbox> mailbox,
                                   const PortChoice& port)
    : pump_{std::move(supervisor), std::move(mailbox)}, port_{makePort(port, this)}, timer_{this} {
  timer_.setSingleShot(true);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &SupervisorWorker::turn);
  connect(port_.get(), &BytePort::opened, this, [this](const QString& name) {
    pump_.supervisor().portOpened(name.toStdString(), steadyNow());
    turn();
  });
  // Not turn(): it may be a write of the turn itself that lost the port.
  connect(port_.get(), &BytePort::lost, this, [this](const Sentence& reason) {
    pump_.supervisor().portLost(reason, steadyNow());
    timer_.start(0);
  });
  connect(port_.get(), &BytePort::received, this, [this](const QByteArray& bytes) {
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.constData());
    pump_.supervisor().ingest({data, static_cast<std::size_t>(bytes.size())}, steadyNow());
    turn();
  });
}

void SupervisorWorker::start() {
  port_->open();
  turn();
}

void SupervisorWorker::close(std::chrono::milliseconds patience) {
  pump_.close(steadyNow() + Seconds{static_cast<double>(patience.count()) / 1000.0});
  turn();
}

void SupervisorWorker::turn() {
  if (ended_) return;
  supervisor::Pump::Turn done = pump_.turn(steadyNow());
  // The next turn is arranged before the write, which may arrange an earlier one.
  const double pause = std::clamp((done.wake - steadyNow()).value(), 0.0, 1.0);
  timer_.start(std::chrono::milliseconds{static_cast<int>(std::ceil(pause * 1000.0))});
  if (!done.bytes.empty()) port_->write(done.bytes);
  if (done.newSnapshot) emit newSnapshot();
  if (done.newEvents) emit newEvents();
  if (!done.closed) return;
  ended_ = true;
  timer_.stop();
  const bool allStood = pump_.supervisor().allStopped();
  port_->close();
  emit closed(allStood);
}

}  // namespace tessera::host
