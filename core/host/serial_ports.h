// The serial ports of this machine, as far as anything stands behind them.
#pragma once

#include <QString>
#include <vector>

namespace tessera::host {

struct SerialPortFound {
  QString port;  ///< "/dev/ttyUSB0"
  QString description;
  QString manufacturer;
  bool builtIn = false;  ///< a chip of this computer; it tells nothing of itself
};

/// Adapters first.
[[nodiscard]] std::vector<SerialPortFound> serialPorts();

/// Linux keeps names for chips that no computer has had for years (ttyS0, ttyS1, …) and knows which of them are there.
/// True where it does not say. `tty`: the folder in which it tells.
[[nodiscard]] bool isThere(const QString& name, const QString& tty = QStringLiteral("/sys/class/tty"));

}  // namespace tessera::host
