#include "host/serial_port.h"

#include <algorithm>

namespace tessera::host {
namespace {

QString reasonOf(QSerialPort::SerialPortError error, const QString& text) {
  switch (error) {
    case QSerialPort::DeviceNotFoundError:
      return QStringLiteral("there is no such device");
    case QSerialPort::PermissionError:
      return QStringLiteral("it is in use by another program, or you may not open it");
    case QSerialPort::OpenError:
      return QStringLiteral("it is open already");
    case QSerialPort::ReadError:
    case QSerialPort::WriteError:
    case QSerialPort::ResourceError:
      return QStringLiteral("the device or the other end is gone");
    default:
      return text;
  }
}

}  // namespace

SerialPort::SerialPort(Options options, QObject* parent)
    : QObject{parent}, options_{std::move(options)}, port_{this}, again_{this}, pause_{options_.firstPause} {
  again_.setSingleShot(true);
  connect(&again_, &QTimer::timeout, this, &SerialPort::tryOpen);
  connect(&port_, &QSerialPort::errorOccurred, this, &SerialPort::onError);
  connect(&port_, &QSerialPort::readyRead, this, [this] {
    const QByteArray bytes = port_.readAll();
    if (open_ && !bytes.isEmpty()) emit received(bytes);
  });
}

void SerialPort::open() {
  wanted_ = true;
  told_ = false;
  pause_ = options_.firstPause;
  tryOpen();
}

void SerialPort::close() {
  wanted_ = false;
  open_ = false;
  again_.stop();
  port_.close();
}

void SerialPort::tryOpen() {
  if (!wanted_ || open_) return;
  port_.setPortName(options_.name);
  port_.setBaudRate(options_.baud);
  port_.setDataBits(QSerialPort::Data8);
  port_.setParity(QSerialPort::NoParity);
  port_.setStopBits(QSerialPort::OneStop);
  port_.setFlowControl(QSerialPort::NoFlowControl);
  if (!port_.open(QIODevice::ReadWrite)) {
    fail(reasonOf(port_.error(), port_.errorString()));
    return;
  }
  // What waits in the driver is from before; a frame cut in half by the opening helps nobody.
  port_.clear();
  open_ = true;
  told_ = false;
  pause_ = options_.firstPause;
  emit opened(options_.name);
}

bool SerialPort::write(std::span<const std::uint8_t> bytes) {
  if (!open_) return false;
  const auto size = static_cast<qint64>(bytes.size());
  if (port_.bytesToWrite() + size > kMaxBacklog) {
    fail(QStringLiteral("the other end does not read"));
    return false;
  }
  // Not flush(): with a full buffer in the kernel it fails instead of waiting for the event loop.
  return port_.write(reinterpret_cast<const char*>(bytes.data()), size) == size && open_;
}

void SerialPort::onError(QSerialPort::SerialPortError error) {
  switch (error) {
    case QSerialPort::ReadError:
    case QSerialPort::WriteError:
    case QSerialPort::ResourceError:
      if (open_) fail(reasonOf(error, port_.errorString()));
      return;
    default:
      // Failures of opening are told by tryOpen(). Others are settings that a pty does not have; they do no harm.
      return;
  }
}

// Closes it, once; the errors that follow find it closed.
void SerialPort::fail(const QString& reason) {
  open_ = false;
  if (port_.isOpen()) {
    const QSignalBlocker quiet{&port_};
    port_.clear(QSerialPort::Output);
    port_.close();
  }
  again_.start(pause_);
  pause_ = std::min(2 * pause_, options_.longestPause);
  if (told_) return;
  told_ = true;
  emit lost(reason);
}

}  // namespace tessera::host
