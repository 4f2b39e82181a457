// A serial port that the program has found on this computer.
#pragma once

#include <QString>

namespace tessera::ui {

struct PortFound {
  QString name;         ///< "/dev/ttyUSB0"
  QString description;  ///< "CP2102 USB to UART Bridge"; may be empty
  bool busy = false;    ///< another program holds it
};

}  // namespace tessera::ui
