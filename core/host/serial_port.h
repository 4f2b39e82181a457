// The edge between Qt's serial port and bytes; the path of a pty is one as well.
//
// What QSerialPort does by itself and this class keeps away from the rest: when the other end of a pty closes, it emits
// errors without end while it still calls itself open; its write buffer grows without bound when nobody reads.
#pragma once

#include <QSerialPort>

#include "host/byte_port.h"

namespace tessera::host {

class SerialPort : public BytePort {
  Q_OBJECT
public:
  /// device: "/dev/ttyUSB0", "COM3", or the path of a pty. 8N1 without flow control.
  SerialPort(const QString& device, qint32 baud, RetryPauses pauses = {}, QObject* parent = nullptr);

  bool setLines(bool rts, bool dtr) override;

private:
  void begin() override;
  void drop() override;
  [[nodiscard]] qint64 backlog() const override { return port_.bytesToWrite(); }
  [[nodiscard]] bool send(const char* bytes, qint64 size) override;
  void onError(QSerialPort::SerialPortError error);

  qint32 baud_;
  QSerialPort port_;
};

}  // namespace tessera::host
