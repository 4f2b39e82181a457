// A vehicle whose firmware runs unmodified in an emulated LM3S6965 (QEMU), in real time.
#pragma once

#include <memory>
#include <string>

#include "sim/vehicle_host.h"

namespace tessera::sim {

struct QemuConfig {
  std::string program;                       ///< path of the firmware's ELF
  std::string eeprom;                        ///< path of the EEPROM's 4096 bytes; made (erased) when there is none
  std::string emulator = "qemu-system-arm";  ///< looked for in PATH
  Seconds startLimit{10.0};                  ///< until the emulated board must stand
};

/// One emulator process and one thread that serves it; both live from start() to kill() or destruction. The process
/// ends with this one, however this one ends. Only start() and kill() wait; everything else hands over values.
/// A reset of the processor (watchdog, restart) is not the end: it goes on by itself with the same pins.
class QemuHost final : public VehicleHost {
public:
  explicit QemuHost(QemuConfig config);
  ~QemuHost() override;
  QemuHost(const QemuHost&) = delete;
  QemuHost& operator=(const QemuHost&) = delete;

  Result<void> start(Seconds now) override;
  void kill() override;
  [[nodiscard]] bool running() const override;
  void setSignals(const Signals& shown) override;
  void fromRadio(std::span<const std::uint8_t> bytes) override;
  void fromReaders(std::span<const std::uint8_t> bytes) override;
  void advance(Seconds now) override;
  [[nodiscard]] Actions take() override;
  [[nodiscard]] std::string trouble() const override;

  /// How often the processor was reset since start().
  [[nodiscard]] int resets() const;
  /// The emulator's process, 0 when there is none. For tests that pull it away.
  [[nodiscard]] int processId() const;

private:
  class Session;
  QemuConfig config_;
  Signals signals_;  ///< as last set; a new session begins with them
  std::unique_ptr<Session> session_;
};

}  // namespace tessera::sim
