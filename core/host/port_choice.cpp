#include "host/port_choice.h"

#include "host/serial_port.h"
#include "host/tcp_port.h"

namespace tessera::host {
namespace {

const QLatin1String kTcp{"tcp://"};

}  // namespace

Result<PortChoice> PortChoice::parse(const QString& words, qint32 baud) {
  const QString text = words.trimmed();
  if (text.isEmpty())
    return failure("No port is named: a serial device such as /dev/ttyUSB0, or tcp://host:port for a device server.");
  if (!text.startsWith(kTcp, Qt::CaseInsensitive)) return PortChoice{Serial{text, baud}};
  const QString place = text.mid(kTcp.size());
  const auto colon = place.lastIndexOf(u':');
  QString host = place.left(colon);
  bool isNumber = false;
  const ushort port = place.mid(colon + 1).toUShort(&isNumber);
  const bool bracketed = host.startsWith(u'[') && host.endsWith(u']');
  if (bracketed) host = host.mid(1, host.size() - 2);
  const bool odd = host.isEmpty() || host.contains(u'/') || host.contains(u' ') || (!bracketed && host.contains(u':'));
  if (colon < 0 || !isNumber || port == 0 || odd)
    return failure("\"" + text.toStdString() +
                   "\" is no device server: it takes a host and a port number, like tcp://192.168.1.20:4001.");
  return PortChoice{Tcp{host, port}};
}

QString PortChoice::text() const {
  if (const auto* serial = std::get_if<Serial>(&to)) return serial->name;
  return TcpPort::nameOf(std::get<Tcp>(to).host, std::get<Tcp>(to).port);
}

PortChoice PortChoice::atBaud(qint32 baud) const {
  PortChoice changed = *this;
  if (auto* serial = std::get_if<Serial>(&changed.to)) serial->baud = baud;
  return changed;
}

std::unique_ptr<BytePort> makePort(const PortChoice& choice, QObject* parent) {
  if (const auto* serial = std::get_if<PortChoice::Serial>(&choice.to))
    return std::make_unique<SerialPort>(serial->name, serial->baud, choice.pauses, parent);
  const auto& tcp = std::get<PortChoice::Tcp>(choice.to);
  return std::make_unique<TcpPort>(tcp.host, tcp.port, choice.pauses, parent);
}

}  // namespace tessera::host
