// The vehicle's electronics on an LM3S6965: joins the drivers to the pins, and serves their interrupts.
//
// Pins: UART0 PA0/1 radio, UART1 PD2/3 readers, I2C0 PB2/3, PWM2/PWM3 PB0/PB1 left/right motor, PC4/PC5 direction
// (high is backwards), radio M0 PE0, M1 PE1, AUX PE2, encoders PA2/PA3 left and PA4/PA5 right, rangers PD4/PD5 and
// PD6/PD7 (trigger, echo). All interrupts have one priority: none interrupts another, each takes a few microseconds.
#pragma once

#include <array>

#include "firmware/boards/lm3s6965/echo_timer.h"
#include "firmware/boards/lm3s6965/i2c_master.h"
#include "firmware/boards/lm3s6965/micros_clock.h"
#include "firmware/boards/lm3s6965/motor_pwm.h"
#include "firmware/boards/lm3s6965/quadrature.h"
#include "firmware/boards/lm3s6965/tick_schedule.h"
#include "firmware/boards/lm3s6965/uart.h"
#include "firmware/boards/lm3s6965/watchdog.h"
#include "firmware/vehicle/board.h"

namespace tessera::firmware::lm3s6965 {

/// There is one of these; its constructor sets up the pins, starts the watchdog and lets interrupts in.
class Lm3s6965Board final : public Board {
public:
  Lm3s6965Board();

  /// True once every 10 ms: time for the 100 Hz work.
  [[nodiscard]] bool tickDue() { return ticks_.due(clock_.now()); }
  /// Sleeps until the next interrupt, at most 1 ms; not at all when one came since the last call.
  void idle();

  std::uint32_t micros() override { return clock_.now(); }
  std::size_t read(Uart port, std::span<std::uint8_t> out) override { return uart(port).read(out); }
  std::size_t write(Uart port, std::span<const std::uint8_t> data) override { return uart(port).write(data); }
  bool sent(Uart port) override { return uart(port).sent(); }
  void setBaud(Uart port, std::uint32_t baud) override { uart(port).setBaud(baud); }
  void setRadioMode(RadioMode mode) override;
  bool radioReady() override;
  bool i2cWrite(std::uint8_t address, std::span<const std::uint8_t> data) override { return i2c_.write(address, data); }
  bool i2cRead(std::uint8_t address, std::span<std::uint8_t> out) override { return i2c_.read(address, out); }
  void drive(Wheel wheel, std::int16_t permille) override { motors_.drive(wheel, permille); }
  std::int32_t counts(Wheel wheel) override { return encoders_[static_cast<std::size_t>(wheel)].count(); }
  void ping(std::size_t ranger) override;
  std::uint32_t echo(std::size_t ranger) override;
  void feedWatchdog() override { watchdog_.feed(); }
  wire::ResetCause resetCause() override;
  void restart() override;
  std::uint8_t hardware() override { return 1; }
  std::uint32_t stackFree() override;

  // For the interrupt handlers.
  void onPortA();
  void onPortD();
  void onUart(Uart port) {
    uart(port).onInterrupt();
    awake_ = true;
  }
  void onWakeUp();

private:
  UartPort& uart(Uart port) { return port == Uart::Radio ? radio_ : readers_; }
  void lookAtEncoders();

  MicrosClock clock_;
  UartPort radio_;
  UartPort readers_;
  I2cMaster i2c_;
  MotorPwm motors_;
  std::array<Quadrature, 2> encoders_;
  std::array<EchoTimer, kRangers> echoes_;
  Watchdog watchdog_;
  TickSchedule ticks_;
  volatile bool awake_ = true;
};

}  // namespace tessera::firmware::lm3s6965
