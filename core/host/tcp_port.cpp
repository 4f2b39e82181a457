#include "host/tcp_port.h"

#include <QNetworkProxy>

#ifdef Q_OS_LINUX
#include <linux/sockios.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#endif

namespace tessera::host {
namespace {

Sentence reasonOf(QAbstractSocket::SocketError error, const QString& text) {
  switch (error) {
    case QAbstractSocket::ConnectionRefusedError:
      return phrase(
          "Core",
          "the device server refuses the connection: its port number may be another one, or somebody else holds it");
    case QAbstractSocket::HostNotFoundError:
      return phrase("Core", "there is no host of this name in the network");
    case QAbstractSocket::RemoteHostClosedError:
      return phrase("Core", "the device server has closed the connection");
    case QAbstractSocket::SocketTimeoutError:
      return phrase("Core", "the device server does not answer: check its power, its address and the network");
    case QAbstractSocket::NetworkError:
      return phrase("Core", "the network does not reach the device server: check the cable and the address");
    default:
      return Sentence{text.toStdString()};
  }
}

// Qt has no names for how long unacknowledged bytes may wait, and for how soon a dead line is looked for.
void limitWaiting([[maybe_unused]] qintptr socket) {
#ifdef Q_OS_LINUX
  const auto set = [&](int option, int value) {
    ::setsockopt(static_cast<int>(socket), IPPROTO_TCP, option, &value, sizeof value);
  };
  set(TCP_USER_TIMEOUT, static_cast<int>(TcpPort::kUnacknowledged.count()));
  set(TCP_KEEPIDLE, 2);
  set(TCP_KEEPINTVL, 1);
  set(TCP_KEEPCNT, 3);
#endif
}

// Bytes that the kernel holds because the other end has not acknowledged them.
qint64 unacknowledged([[maybe_unused]] qintptr socket) {
#ifdef Q_OS_LINUX
  int waiting = 0;
  if (socket >= 0 && ::ioctl(static_cast<int>(socket), SIOCOUTQ, &waiting) == 0) return waiting;
#endif
  return 0;
}

}  // namespace

TcpPort::TcpPort(const QString& host, quint16 port, RetryPauses pauses, QObject* parent,
                 std::chrono::milliseconds patience)
    : BytePort{nameOf(host, port), pauses, parent},
      host_{host},
      port_{port},
      patience_{patience},
      socket_{this},
      late_{this} {
  socket_.setProxy(QNetworkProxy::NoProxy);  // the radio stands in the plant's own network
  late_.setSingleShot(true);
  connect(&late_, &QTimer::timeout, this, [this] { fail(reasonOf(QAbstractSocket::SocketTimeoutError, {})); });
  connect(&socket_, &QTcpSocket::connected, this, &TcpPort::connected);
  connect(&socket_, &QTcpSocket::readyRead, this, [this] { hear(socket_.readAll()); });
  connect(&socket_, &QTcpSocket::errorOccurred, this, [this](QAbstractSocket::SocketError error) {
    if (wanted()) fail(reasonOf(error, socket_.errorString()));
  });
}

QString TcpPort::nameOf(const QString& host, quint16 port) {
  return (host.contains(u':') ? QStringLiteral("tcp://[%1]:%2") : QStringLiteral("tcp://%1:%2")).arg(host).arg(port);
}

void TcpPort::begin() {
  drop();
  late_.start(patience_);
  socket_.connectToHost(host_, port_);
}

void TcpPort::connected() {
  late_.stop();
  socket_.setSocketOption(QAbstractSocket::LowDelayOption, 1);
  socket_.setSocketOption(QAbstractSocket::KeepAliveOption, 1);
  limitWaiting(socket_.socketDescriptor());
  nowOpen();
}

qint64 TcpPort::backlog() const { return socket_.bytesToWrite() + unacknowledged(socket_.socketDescriptor()); }

bool TcpPort::send(const char* bytes, qint64 size) { return socket_.write(bytes, size) == size; }

// abort(), not close(): old commands must not be delivered after all.
void TcpPort::drop() {
  late_.stop();
  const QSignalBlocker quiet{&socket_};
  socket_.abort();
}

}  // namespace tessera::host
