// The line between a vehicle's electronics and the world around it, the same whether the firmware runs in this process
// or in an emulated microcontroller. The world turns the plant's state into signals, hands them over, lets the
// firmware run up to an instant, and takes what it did.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/units.h"
#include "firmware/vehicle/board.h"

namespace tessera::sim {

/// What sensors and pins show to the firmware at one instant.
struct Signals {
  std::array<std::int64_t, 2> encoderCounts{};  ///< left, right; quadrature counts since the start of the world
  std::array<double, 3> field{};                ///< µT along the compass chip's x, y, z axes, noise included
  /// Distance each ranger would measure. 0 or less: nothing in reach, its pulse ends after 38 ms; NaN: the ranger is
  /// dead and gives no pulse at all.
  std::array<Metres, firmware::kRangers> range{};
  bool radioReady = true;  ///< AUX
};

/// What the firmware put on its pins and wires since it was last asked.
struct Actions {
  std::array<int, 2> duty{};  ///< left, right; -1000 to 1000, as it stands now
  firmware::RadioMode radioMode = firmware::RadioMode::Normal;
  std::vector<std::uint8_t> toRadio;
  std::vector<std::uint8_t> toReaders;
};

class VehicleHost {
public:
  virtual ~VehicleHost() = default;
  /// Switches the vehicle on (again). Fails with a sentence, e.g. when the emulator is not installed.
  virtual Result<void> start(Seconds now) = 0;
  /// Switches it off at once, as if the battery were pulled. Its EEPROM stays.
  virtual void kill() = 0;
  [[nodiscard]] virtual bool running() const = 0;

  virtual void setSignals(const Signals& shown) = 0;
  virtual void fromRadio(std::span<const std::uint8_t> bytes) = 0;    ///< bytes that the E32 puts on UART0 now
  virtual void fromReaders(std::span<const std::uint8_t> bytes) = 0;  ///< bytes on the reader bus now
  /// Lets the firmware run up to `now` (world time). An emulated one runs by itself in real time.
  virtual void advance(Seconds now) = 0;
  [[nodiscard]] virtual Actions take() = 0;
  /// Why it is not running, a sentence; empty when it is.
  [[nodiscard]] virtual std::string trouble() const { return {}; }
};

}  // namespace tessera::sim
