// Starts the emulator with its wires (socket pairs and a pipe: nothing in the file system that could collide or stay)
// and ends it.
#pragma once

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace tessera::sim {

/// A file descriptor that is closed once.
class Descriptor {
public:
  Descriptor() = default;
  explicit Descriptor(int fd) : fd_{fd} {}
  Descriptor(Descriptor&& o) noexcept : fd_{std::exchange(o.fd_, -1)} {}
  Descriptor& operator=(Descriptor&& o) noexcept;
  ~Descriptor() { close(); }
  void close();
  [[nodiscard]] int get() const { return fd_; }

private:
  int fd_ = -1;
};

/// This side's ends of the emulator's wires. All are non-blocking.
struct QemuWires {
  Descriptor radio;    ///< UART0
  Descriptor readers;  ///< UART1
  Descriptor control;  ///< QMP
  Descriptor pins;     ///< qtest protocol
  Descriptor log;      ///< standard error: traces and messages
};

class QemuProcess {
public:
  QemuProcess() = default;
  QemuProcess(const QemuProcess&) = delete;
  QemuProcess& operator=(const QemuProcess&) = delete;
  ~QemuProcess() { end(); }

  /// The machine waits for the first "cont". The emulator dies with the calling thread, which is to live as long.
  [[nodiscard]] Result<QemuWires> start(const std::string& emulator, const std::string& program,
                                        const std::string& eeprom);
  void end();
  [[nodiscard]] pid_t id() const { return id_; }

private:
  pid_t id_ = 0;
};

/// Makes the EEPROM's file as an erased part when it is missing. Fails when it is there and no 4096 bytes.
[[nodiscard]] Result<void> prepareEeprom(const std::string& path);

}  // namespace tessera::sim
