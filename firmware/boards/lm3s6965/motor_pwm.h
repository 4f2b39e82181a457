// The two motors' drive: pulse width on PWM2 and PWM3 (generator 1), direction on one pin each.
#pragma once

#include <array>
#include <cstdint>

#include "firmware/boards/lm3s6965/registers.h"
#include "firmware/vehicle/board.h"

namespace tessera::firmware::lm3s6965 {

inline constexpr std::uint32_t kPwmPeriod = 2500;  ///< clocks: 20 kHz, above hearing

/// How long the output is high in each period, in clocks, for a duty of 0 to 1000.
[[nodiscard]] constexpr std::uint32_t highClocks(std::uint32_t permille) {
  return (permille > 1000 ? 1000 : permille) * kPwmPeriod / 1000;
}
/// The counter runs down from kPwmPeriod - 1: the output rises there and falls at the compare value. Full drive is one
/// clock short of the period.
[[nodiscard]] constexpr std::uint32_t compareFor(std::uint32_t high) {
  return high >= kPwmPeriod ? 0 : kPwmPeriod - 1 - high;
}

/// Writes registers only when a value changes.
class MotorPwm {
public:
  /// directions: the port of both direction pins; high is backwards.
  MotorPwm(PwmRegisters& pwm, GpioRegisters& directions, std::uint8_t leftPin, std::uint8_t rightPin);
  /// permille -1000 to 1000 (held to that range); 0 switches the output off, which brakes.
  void drive(Wheel wheel, std::int16_t permille);

private:
  struct Motor {
    std::uint32_t directionPin = 0;
    std::uint32_t enableBit = 0;
    std::uint32_t compare = 0;
    bool backwards = false;
    bool enabled = false;
  };
  void setCompare(Wheel wheel, std::uint32_t value);

  PwmRegisters& pwm_;
  GpioRegisters& directions_;
  std::array<Motor, 2> motors_;
};

}  // namespace tessera::firmware::lm3s6965
