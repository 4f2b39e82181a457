#include "host/byte_port.h"

#include <algorithm>

namespace tessera::host {

BytePort::BytePort(QString name, RetryPauses pauses, QObject* parent)
    : QObject{parent}, name_{std::move(name)}, pauses_{pauses}, again_{this}, steady_{this}, pause_{pauses.first} {
  again_.setSingleShot(true);
  steady_.setSingleShot(true);
  connect(&again_, &QTimer::timeout, this, &BytePort::tryOpen);
  connect(&steady_, &QTimer::timeout, this, [this] { pause_ = pauses_.first; });
}

bool BytePort::setLines(bool, bool) { return false; }

void BytePort::open() {
  wanted_ = true;
  told_ = false;
  pause_ = pauses_.first;
  tryOpen();
}

void BytePort::close() {
  wanted_ = false;
  open_ = false;
  again_.stop();
  steady_.stop();
  drop();
}

void BytePort::tryOpen() {
  if (wanted_ && !open_) begin();
}

// A device server that is in use takes a connection and closes it at once: pauses shorten only when a port has held.
void BytePort::nowOpen() {
  open_ = true;
  told_ = false;
  steady_.start(pauses_.longest);
  Q_EMIT opened(name_);
}

void BytePort::hear(const QByteArray& bytes) {
  if (!open_ || bytes.isEmpty()) return;
  pause_ = pauses_.first;
  Q_EMIT received(bytes);
}

bool BytePort::write(std::span<const std::uint8_t> bytes) {
  if (!open_) return false;
  const auto size = static_cast<qint64>(bytes.size());
  if (backlog() + size > kMaxBacklog) {
    fail(phrase("Core", "the other end does not read"));
    return false;
  }
  return send(reinterpret_cast<const char*>(bytes.data()), size) && open_;
}

void BytePort::fail(const Sentence& reason) {
  open_ = false;
  steady_.stop();
  drop();
  if (wanted_) again_.start(pause_);
  pause_ = std::min(2 * pause_, pauses_.longest);
  if (told_) return;
  told_ = true;
  Q_EMIT lost(reason);
}

}  // namespace tessera::host
