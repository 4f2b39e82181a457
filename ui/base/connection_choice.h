// How the host reaches its radio: what the connection dialogue gives and the program opens.
#pragma once

#include <QString>

namespace tessera::ui {

struct ConnectionChoice {
  enum class Kind {
    Serial,  ///< a serial device or the path of a pty
    Tcp,     ///< a serial device server: raw bytes over TCP
    Demo,    ///< a simulated world, started by the program
  };
  Kind kind = Kind::Demo;
  QString port;            ///< Serial: "/dev/ttyUSB0", "COM3", any path
  int baud = 115200;       ///< Serial: bit/s
  QString host;            ///< Tcp: name or address
  quint16 tcpPort = 4001;  ///< Tcp
  bool operator==(const ConnectionChoice&) const = default;
};

}  // namespace tessera::ui
