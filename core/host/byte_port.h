// A stream of bytes to the radio, whatever carries it: a serial device, a pty, a TCP connection to a device server.
// Opens it, opens it again when it was lost, and tells each loss once. What differs is left to the classes below it.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QTimer>
#include <chrono>
#include <cstdint>
#include <span>

#include "base/sentence.h"

namespace tessera::host {

/// How long to wait before a port is opened again; doubles from the first to the longest.
struct RetryPauses {
  std::chrono::milliseconds first{100};
  std::chrono::milliseconds longest{1000};
  bool operator==(const RetryPauses&) const = default;
};

class BytePort : public QObject {
  Q_OBJECT
public:
  /// Bytes that may wait for the other end to read; with more it counts as lost.
  static constexpr qint64 kMaxBacklog = 4096;

  /// name: as a person would write it, "/dev/ttyUSB0", "tcp://10.0.0.5:4001".
  BytePort(QString name, RetryPauses pauses, QObject* parent);

  [[nodiscard]] const QString& name() const { return name_; }
  /// Opens it now or, with ever longer pauses, as soon as it is there. opened() or lost() follow, perhaps at once.
  void open();
  void close();
  [[nodiscard]] bool isOpen() const { return open_; }
  /// Hands over bytes in one go. False: not open, or lost by this.
  bool write(std::span<const std::uint8_t> bytes);
  /// Sets the lines RTS and DTR, true being the active level (0 V on a TTL adapter). False: this port has none.
  virtual bool setLines(bool rts, bool dtr);

Q_SIGNALS:
  void opened(const QString& name);
  /// Once until it is opened again; reason: the end of a sentence, "there is no such device".
  void lost(const tessera::Sentence& reason);
  void received(const QByteArray& bytes);

protected:
  /// Begins to open; ends, now or later, in nowOpen() or fail().
  virtual void begin() = 0;
  /// Lets go of the device in whatever state it is, what waits to be written included. Emits nothing.
  virtual void drop() = 0;
  /// Bytes that the other end has not taken yet.
  [[nodiscard]] virtual qint64 backlog() const = 0;
  [[nodiscard]] virtual bool send(const char* bytes, qint64 size) = 0;

  [[nodiscard]] bool wanted() const { return wanted_; }
  void nowOpen();
  void hear(const QByteArray& bytes);
  /// It could not be opened, or is lost: drops it, tells so once and tries again after a pause.
  void fail(const Sentence& reason);

private:
  void tryOpen();

  QString name_;
  RetryPauses pauses_;
  QTimer again_;
  QTimer steady_;  ///< open for so long that the next loss is a new one, not the same one still
  std::chrono::milliseconds pause_;
  bool wanted_ = false;
  bool open_ = false;
  bool told_ = false;
};

}  // namespace tessera::host
