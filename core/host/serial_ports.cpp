#include "host/serial_ports.h"

#include <QFile>
#include <QSerialPortInfo>
#include <algorithm>

namespace tessera::host {

bool isThere(const QString& name, const QString& tty) {
  QFile type{tty + QLatin1Char{'/'} + name + QStringLiteral("/type")};
  if (!type.open(QIODevice::ReadOnly)) return true;
  return type.readAll().trimmed() != "0";
}

std::vector<SerialPortFound> serialPorts() {
  std::vector<SerialPortFound> found;
  for (const QSerialPortInfo& info : QSerialPortInfo::availablePorts()) {
    if (!isThere(info.portName())) continue;
    const bool builtIn = info.portName().startsWith(QLatin1String{"ttyS"}) && info.description().isEmpty() &&
                         !info.hasVendorIdentifier();
    found.push_back({info.systemLocation(), info.description(), info.manufacturer(), builtIn});
  }
  std::stable_partition(found.begin(), found.end(), [](const SerialPortFound& port) { return !port.builtIn; });
  return found;
}

}  // namespace tessera::host
