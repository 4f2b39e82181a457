// A vehicle whose firmware runs in this process: the same sources as on the microcontroller, over the host board, in
// the world's own time. Hundreds fit into a process, and runs repeat bit by bit.
#pragma once

#include <cstdint>
#include <optional>

#include "firmware/boards/host/host_board.h"
#include "firmware/vehicle/vehicle.h"
#include "sim/vehicle_host.h"

namespace tessera::sim {

class NativeHost final : public VehicleHost {
public:
  /// eeprom: what the vehicle's EEPROM holds before its first start.
  explicit NativeHost(const firmware::EepromChip::Image& eeprom) : board_{eeprom} {}

  Result<void> start(Seconds now) override;
  void kill() override;
  [[nodiscard]] bool running() const override { return vehicle_.has_value(); }
  void setSignals(const Signals& shown) override;
  void fromRadio(std::span<const std::uint8_t> bytes) override;
  void fromReaders(std::span<const std::uint8_t> bytes) override;
  /// poll() at least each ms, tick() each 10 ms; late when the firmware itself was busy for longer.
  void advance(Seconds now) override;
  [[nodiscard]] Actions take() override;

  /// Also while it is switched off.
  [[nodiscard]] const firmware::EepromChip::Image& eeprom() const { return board_.eeprom(); }
  /// For tests that break a chip.
  [[nodiscard]] firmware::HostBoard& board() { return board_; }
  /// Starts since it was made, restarts included.
  [[nodiscard]] int starts() const { return starts_; }

private:
  void boot(wire::ResetCause cause);

  firmware::HostBoard board_;
  std::optional<firmware::Vehicle> vehicle_;
  std::uint64_t nextTick_ = 0;  ///< µs of the world's clock
  int starts_ = 0;
};

}  // namespace tessera::sim
