#include "firmware/boards/lm3s6965/motor_pwm.h"

#include <algorithm>

namespace tessera::firmware::lm3s6965 {
namespace {

constexpr std::uint32_t kHighAtLoad = 3U << 2;
constexpr std::uint32_t kLowAtCompareA = 2U << 6;
constexpr std::uint32_t kLowAtCompareB = 2U << 10;

}  // namespace

MotorPwm::MotorPwm(PwmRegisters& pwm, GpioRegisters& directions, std::uint8_t leftPin, std::uint8_t rightPin)
    : pwm_{pwm}, directions_{directions} {
  motors_[0] = {leftPin, 1U << 2, kPwmPeriod - 1, false, false};
  motors_[1] = {rightPin, 1U << 3, kPwmPeriod - 1, false, false};
  PwmGeneratorRegisters& generator = pwm_.GENERATOR[1];
  pwm_.ENABLE = 0;
  generator.CTL = 0;  // off, counting down
  generator.GENA = kHighAtLoad | kLowAtCompareA;
  generator.GENB = kHighAtLoad | kLowAtCompareB;
  generator.LOAD = kPwmPeriod - 1;
  generator.CMPA = kPwmPeriod - 1;
  generator.CMPB = kPwmPeriod - 1;
  generator.CTL = 1;
  directions_.DATA[leftPin | rightPin] = 0;
}

void MotorPwm::drive(Wheel wheel, std::int16_t permille) {
  Motor& motor = motors_[static_cast<std::size_t>(wheel)];
  const std::int32_t duty = std::clamp<std::int32_t>(permille, -1000, 1000);
  const bool backwards = duty == 0 ? motor.backwards : duty < 0;
  const bool enabled = duty != 0;
  if (backwards != motor.backwards) {
    motor.backwards = backwards;
    directions_.DATA[motor.directionPin] = backwards ? motor.directionPin : 0;
  }
  if (enabled) setCompare(wheel, compareFor(highClocks(static_cast<std::uint32_t>(duty < 0 ? -duty : duty))));
  if (enabled != motor.enabled) {
    motor.enabled = enabled;
    const std::uint32_t others =
        motors_[wheel == Wheel::Left ? 1 : 0].enabled ? motors_[wheel == Wheel::Left ? 1 : 0].enableBit : 0;
    pwm_.ENABLE = others | (enabled ? motor.enableBit : 0);
  }
}

void MotorPwm::setCompare(Wheel wheel, std::uint32_t value) {
  Motor& motor = motors_[static_cast<std::size_t>(wheel)];
  if (motor.compare == value) return;
  motor.compare = value;
  PwmGeneratorRegisters& generator = pwm_.GENERATOR[1];
  (wheel == Wheel::Left ? generator.CMPA : generator.CMPB) = value;
}

}  // namespace tessera::firmware::lm3s6965
