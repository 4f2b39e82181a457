// Which port leads to the radio, as a value: chosen in a dialogue, written on a command line, kept in settings.
#pragma once

#include <memory>
#include <variant>

#include "base/result.h"
#include "host/byte_port.h"

namespace tessera::host {

struct PortChoice {
  struct Serial {
    QString name;          ///< "/dev/ttyUSB0", "COM3", or the path of a pty
    qint32 baud = 115200;  ///< bit/s
    bool operator==(const Serial&) const = default;
  };
  struct Tcp {
    QString host;  ///< a name or an address
    quint16 port = 4001;
    bool operator==(const Tcp&) const = default;
  };
  std::variant<Serial, Tcp> to;
  RetryPauses pauses{};

  /// "tcp://host:port" (an IPv6 address in brackets), or the name of a serial device, which gets this baud.
  /// Error: a sentence that quotes the words and shows the right form.
  [[nodiscard]] static Result<PortChoice> parse(const QString& words, qint32 baud);
  /// The words that parse() takes.
  [[nodiscard]] QString text() const;
  /// The same with another baud; a device server's is set on the server, so that a Tcp stays as it is.
  [[nodiscard]] PortChoice atBaud(qint32 baud) const;
  bool operator==(const PortChoice&) const = default;
};

/// A port that is not opened yet; belongs to `parent` where there is one.
[[nodiscard]] std::unique_ptr<BytePort> makePort(const PortChoice& choice, QObject* parent = nullptr);

}  // namespace tessera::host
