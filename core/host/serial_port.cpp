#include "host/serial_port.h"

namespace tessera::host {
namespace {

Sentence reasonOf(QSerialPort::SerialPortError error, const QString& text) {
  switch (error) {
    case QSerialPort::DeviceNotFoundError:
      return phrase("Core", "there is no such device");
    case QSerialPort::PermissionError:
      return phrase("Core", "it is in use by another program, or you may not open it");
    case QSerialPort::OpenError:
      return phrase("Core", "it is open already");
    case QSerialPort::ReadError:
    case QSerialPort::WriteError:
    case QSerialPort::ResourceError:
      return phrase("Core", "the device or the other end is gone");
    default:
      return Sentence{text.toStdString()};
  }
}

}  // namespace

SerialPort::SerialPort(const QString& device, qint32 baud, RetryPauses pauses, QObject* parent)
    : BytePort{device, pauses, parent}, baud_{baud}, port_{this} {
  connect(&port_, &QSerialPort::errorOccurred, this, &SerialPort::onError);
  connect(&port_, &QSerialPort::readyRead, this, [this] { hear(port_.readAll()); });
}

void SerialPort::begin() {
  port_.setPortName(name());
  port_.setBaudRate(baud_);
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
  nowOpen();
}

bool SerialPort::setLines(bool rts, bool dtr) {
  // Both are tried, as an adapter may have one of them only.
  const bool first = isOpen() && port_.setRequestToSend(rts);
  const bool second = isOpen() && port_.setDataTerminalReady(dtr);
  return first && second;
}

// Not flush(): with a full buffer in the kernel it fails instead of waiting for the event loop.
bool SerialPort::send(const char* bytes, qint64 size) { return port_.write(bytes, size) == size; }

void SerialPort::onError(QSerialPort::SerialPortError error) {
  switch (error) {
    case QSerialPort::ReadError:
    case QSerialPort::WriteError:
    case QSerialPort::ResourceError:
      if (isOpen()) fail(reasonOf(error, port_.errorString()));
      return;
    default:
      // Failures of opening are told by begin(). Others are settings and lines that a pty does not have; no harm.
      return;
  }
}

// The errors that closing brings, and those that follow a loss, are nobody's business.
void SerialPort::drop() {
  if (!port_.isOpen()) return;
  const QSignalBlocker quiet{&port_};
  port_.clear(QSerialPort::Output);
  port_.close();
}

}  // namespace tessera::host
