// The radio behind a serial device server (ser2net, Moxa, an Ethernet-to-serial adapter in raw mode): the same bytes
// over TCP. The server's own serial settings (baud, 8N1) are set on the server.
//
// What TCP would do by itself and this class keeps away from the rest: it would keep old commands for a dead connection
// and deliver them late. A connection whose bytes are not acknowledged within kUnacknowledged is dropped, with them.
#pragma once

#include <QTcpSocket>

#include "host/byte_port.h"

namespace tessera::host {

class TcpPort : public BytePort {
  Q_OBJECT
public:
  static constexpr std::chrono::milliseconds kUnacknowledged{2000};

  /// host: a name or an address. patience: for the connection to stand.
  TcpPort(const QString& host, quint16 port, RetryPauses pauses = {}, QObject* parent = nullptr,
          std::chrono::milliseconds patience = std::chrono::milliseconds{3000});

  /// "tcp://host:port"; an IPv6 address in brackets.
  [[nodiscard]] static QString nameOf(const QString& host, quint16 port);

private:
  void begin() override;
  void drop() override;
  [[nodiscard]] qint64 backlog() const override;
  [[nodiscard]] bool send(const char* bytes, qint64 size) override;
  void connected();

  QString host_;
  quint16 port_;
  std::chrono::milliseconds patience_;
  QTcpSocket socket_;
  QTimer late_;
};

}  // namespace tessera::host
