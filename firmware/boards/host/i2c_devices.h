// The two chips on the vehicle's I2C bus, as their data sheets describe them: compass HMC5883L (Honeywell, rev. E) and
// EEPROM AT24C32 (Microchip/Atmel, rev. I). Instants are µs counted by the board.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace tessera::firmware {

/// ChipField along a chip's x, y, z axes, µT.
using ChipField = std::array<double, 3>;

/// Registers 0 to 12, continuous and single measurement, gain, data lock, overflow. Self-test currents are not
/// modelled.
class CompassChip {
public:
  static constexpr std::uint8_t kAddress = 0x1E;

  void powerOn(std::uint64_t now);
  /// Lets the chip measure when its time has come. To be called at least every ms.
  void step(std::uint64_t now, const ChipField& field);
  bool write(std::span<const std::uint8_t> data, std::uint64_t now);
  bool read(std::span<std::uint8_t> out);

private:
  void setRegister(std::uint8_t index, std::uint8_t value, std::uint64_t now);
  void measure(const ChipField& field);

  std::array<std::uint8_t, 13> registers_{};
  std::uint8_t pointer_ = 0;
  std::uint8_t unread_ = 0;  ///< data registers of a locked result that nobody has read yet
  std::uint8_t gain_ = 1;    ///< in force; a new one only from the second measurement on
  bool measuring_ = false;
  std::uint64_t due_ = 0;
};

/// 4096 bytes in pages of 32; deaf for 5 ms after a write, during which it programs its cells.
class EepromChip {
public:
  static constexpr std::uint8_t kAddress = 0x50;
  static constexpr std::size_t kSize = 4096;
  static constexpr std::size_t kPage = 32;
  static constexpr std::uint64_t kWriteCycle = 5000;
  using Image = std::array<std::uint8_t, kSize>;

  explicit EepromChip(const Image& image) : cells_{image} {}
  void powerOn() { busyUntil_ = 0; }
  bool write(std::span<const std::uint8_t> data, std::uint64_t now);
  bool read(std::span<std::uint8_t> out, std::uint64_t now);
  [[nodiscard]] const Image& image() const { return cells_; }

private:
  Image cells_;
  std::size_t pointer_ = 0;
  std::uint64_t busyUntil_ = 0;
};

}  // namespace tessera::firmware
