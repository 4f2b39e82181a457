// The compass chip HMC5883L (I2C 0x1E): identification "H43", eight-fold averaging at 75 Hz, continuous mode. Read at
// 50 Hz, all six data bytes (which stand in the order X, Z, Y). Only the horizontal components are used.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "firmware/vehicle/board.h"
#include "firmware/vehicle/time.h"

namespace tessera::firmware {

/// A horizontal field along the chip's axes, µT. x as printed on the chip, y a quarter turn to its left, z up.
struct Field {
  float x = 0.0F;
  float y = 0.0F;
};

class Hmc5883l {
public:
  static constexpr std::uint8_t kAddress = 0x1E;

  explicit Hmc5883l(Board& board) : board_{board} {}

  /// To be called every tick; returns a sample 50 times a second. A chip that does not answer is tried again twice a
  /// second. Fields too strong for the range widen it, up to 8.1 G; the sample after that is old and is dropped.
  std::optional<Field> tick(Micros now);

  /// Three accesses running have failed, or it is another chip.
  [[nodiscard]] bool absent() const { return failures_ >= kFailuresToAbsent; }
  /// The last sample was beyond the range.
  [[nodiscard]] bool overflowed() const { return overflows_ > 0; }

private:
  static constexpr int kFailuresToAbsent = 3;
  bool set(std::uint8_t reg, std::uint8_t value);
  bool get(std::uint8_t reg, std::span<std::uint8_t> out);
  bool configure();
  void failed(Micros now);
  std::optional<Field> convert(const std::array<std::uint8_t, 6>& raw);

  Board& board_;
  bool running_ = false;
  int failures_ = 0;
  int overflows_ = 0;
  int drop_ = 0;
  std::uint8_t gain_ = 1;
  Micros next_{0};
};

}  // namespace tessera::firmware
