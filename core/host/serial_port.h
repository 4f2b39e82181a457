// The edge between Qt's serial port and bytes: opens it, opens it again when it was lost, and tells each loss once.
//
// What QSerialPort does by itself and this class keeps away from the rest: when the other end of a pty closes, it emits
// errors without end while it still calls itself open; its write buffer grows without bound when nobody reads.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QSerialPort>
#include <QString>
#include <QTimer>
#include <chrono>
#include <cstdint>
#include <span>

namespace tessera::host {

class SerialPort : public QObject {
  Q_OBJECT
public:
  struct Options {
    QString name;  ///< "/dev/ttyUSB0", "COM3", or the path of a pty
    qint32 baud = 115200;
    std::chrono::milliseconds firstPause{100};  ///< before it is opened again; doubles
    std::chrono::milliseconds longestPause{1000};
  };
  /// Bytes that may wait for the other end to read; with more it counts as lost.
  static constexpr qint64 kMaxBacklog = 4096;

  explicit SerialPort(Options options, QObject* parent = nullptr);

  /// Opens it now or, with ever longer pauses, as soon as it is there.
  void open();
  void close();
  [[nodiscard]] bool isOpen() const { return open_; }
  /// Hands over bytes in one go. False: not open, or lost by this.
  bool write(std::span<const std::uint8_t> bytes);

signals:
  void opened(const QString& name);
  /// Once until it is opened again; reason: the end of a sentence, "the device is gone".
  void lost(const QString& reason);
  void received(const QByteArray& bytes);

private:
  void tryOpen();
  void onError(QSerialPort::SerialPortError error);
  void fail(const QString& reason);

  Options options_;
  QSerialPort port_;
  QTimer again_;
  std::chrono::milliseconds pause_;
  bool wanted_ = false;
  bool open_ = false;
  bool told_ = false;
};

}  // namespace tessera::host
