#include "app/tessera/settings.h"

namespace tessera::desktop {

using ui::ConnectionChoice;

void Settings::setWindow(const QByteArray& geometry, const QByteArray& layout) {
  store_.setValue("window/geometry", geometry);
  store_.setValue("window/layout", layout);
}

void Settings::addRecent(const QString& path) {
  QStringList paths = recent();
  paths.removeAll(path);
  paths.prepend(path);
  while (paths.size() > kMostRecent) paths.removeLast();
  store_.setValue("recent", paths);
}

void Settings::forgetRecent(const QString& path) {
  QStringList paths = recent();
  paths.removeAll(path);
  store_.setValue("recent", paths);
}

ConnectionChoice Settings::connection() const {
  ConnectionChoice choice;
  const QString kind = store_.value("connection/kind", "demo").toString();
  if (kind == QLatin1String{"serial"}) choice.kind = ConnectionChoice::Kind::Serial;
  if (kind == QLatin1String{"tcp"}) choice.kind = ConnectionChoice::Kind::Tcp;
  choice.port = store_.value("connection/port").toString();
  choice.baud = store_.value("connection/baud", choice.baud).toInt();
  choice.host = store_.value("connection/host").toString();
  choice.tcpPort = static_cast<quint16>(store_.value("connection/tcp_port", choice.tcpPort).toUInt());
  return choice;
}

void Settings::setConnection(const ConnectionChoice& choice) {
  const char* kind = choice.kind == ConnectionChoice::Kind::Serial ? "serial"
                     : choice.kind == ConnectionChoice::Kind::Tcp  ? "tcp"
                                                                   : "demo";
  store_.setValue("connection/kind", kind);
  store_.setValue("connection/port", choice.port);
  store_.setValue("connection/baud", choice.baud);
  store_.setValue("connection/host", choice.host);
  store_.setValue("connection/tcp_port", choice.tcpPort);
}

}  // namespace tessera::desktop
