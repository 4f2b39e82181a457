// Watchdog timer 0: ends a program that has lost its way.
#pragma once

#include "firmware/boards/lm3s6965/clock.h"
#include "firmware/boards/lm3s6965/registers.h"

namespace tessera::firmware::lm3s6965 {

/// The first time-out only raises a flag, the second one resets: a program may be silent for one to two periods.
class Watchdog {
public:
  static constexpr std::uint32_t kPeriodMs = 300;

  explicit Watchdog(WatchdogRegisters& registers) : registers_{registers} {}

  /// From here on it cannot be stopped but by a reset.
  void start() {
    registers_.LOCK = kUnlock;
    registers_.LOAD = kClockHz / 1000 * kPeriodMs;
    registers_.CTL = 0b10;  // reset at the second time-out
    registers_.CTL = 0b11;  // run
    registers_.LOCK = 0;
  }
  void feed() {
    registers_.LOCK = kUnlock;
    registers_.ICR = 1;  // clears the flag and reloads the counter
    registers_.LOCK = 0;
  }

private:
  static constexpr std::uint32_t kUnlock = 0x1ACCE551;
  WatchdogRegisters& registers_;
};

}  // namespace tessera::firmware::lm3s6965
