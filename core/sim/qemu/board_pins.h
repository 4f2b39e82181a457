// The emulated board seen from its pins and its I2C bus: shows the world's signals to it, and collects what the
// firmware does with its outputs.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim/qemu/pin_logic.h"
#include "sim/qemu/qemu_link.h"
#include "sim/vehicle_host.h"

namespace tessera::sim {

/// Used by the session's thread alone.
class BoardPins {
public:
  /// Looks up where this emulator keeps the board's ports, by their addresses.
  [[nodiscard]] Result<void> find(QemuLink& link);
  /// To be called for every line of the emulator's log.
  void onTrace(const TraceEvent& event);
  /// Puts all inputs to their levels before the processor starts. The wheels' counts of now are its zero.
  [[nodiscard]] Result<void> begin(QemuLink& link, const Signals& shown);
  /// Shows what is due: one step of each encoder at most, edges of echoes, AUX, the field. Right after a reset of the
  /// processor, which clears the ports, all of it anew.
  [[nodiscard]] Result<void> serve(QemuLink& link, const Signals& shown);
  /// Until serve() has work again.
  [[nodiscard]] Seconds rest(Seconds now) const;

  [[nodiscard]] int duty(std::size_t motor) const { return motors_.duty(motor); }
  [[nodiscard]] firmware::RadioMode radioMode() const { return static_cast<firmware::RadioMode>(levels_[E] & 3U); }
  [[nodiscard]] int resets() const { return resets_; }
  /// The last thing that the emulator said in its own words; empty when it said nothing.
  [[nodiscard]] const std::string& lastRemark() const { return lastRemark_; }

private:
  enum Port : std::size_t { A, C, D, E, kPorts };

  void onPin(Port port, unsigned pin, bool high);
  [[nodiscard]] Result<void> showAllInputs(QemuLink& link);
  [[nodiscard]] Result<void> showRadioReady(QemuLink& link);
  void showField(QemuLink& link);
  [[nodiscard]] Result<void> stepEncoders(QemuLink& link);
  [[nodiscard]] Result<void> serveEchoes(QemuLink& link);
  [[nodiscard]] std::string pinCommand(Port port, unsigned pin, bool high) const;
  [[nodiscard]] std::vector<std::string> encoderCommands(std::size_t wheel, unsigned before, unsigned levels) const;

  std::array<std::string, kPorts> portPaths_;
  std::array<unsigned, kPorts> levels_{};  ///< outputs, as traced
  MotorOutputs motors_;
  std::array<EchoSource, firmware::kRangers> echoes_;
  Seconds pinDelay_{30e-6};  ///< from an order to the emulator to the pin, as seen lately
  Signals signals_;
  std::array<std::int64_t, 2> shown_{};  ///< encoder counts that the pins stand for
  bool counting_ = false;                ///< the firmware's encoder interrupts are on
  bool wasReset_ = false;
  bool shownReady_ = true;
  std::array<double, 3> shownField_{};
  Seconds nextField_{};
  int fieldLooks_ = 0;
  int resets_ = 0;
  std::string lastRemark_;
};

}  // namespace tessera::sim
