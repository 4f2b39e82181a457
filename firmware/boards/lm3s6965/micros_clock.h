// The board's free-running microseconds, from the core's SysTick counter.
#pragma once

#include "firmware/boards/lm3s6965/clock.h"
#include "firmware/boards/lm3s6965/interrupt_lock.h"
#include "firmware/boards/lm3s6965/micros_counter.h"
#include "firmware/boards/lm3s6965/registers.h"

namespace tessera::firmware::lm3s6965 {

class MicrosClock {
public:
  explicit MicrosClock(SysTickRegisters& registers) : registers_{registers} {
    registers_.CTRL = 0;
    registers_.RELOAD = Counter::kMask;
    registers_.CURRENT = 0;   // any write clears it; the first tick loads RELOAD
    registers_.CTRL = 0b101;  // run from the processor's clock, no interrupt
  }

  /// From the main loop and from interrupt handlers alike. To be called at least every 0.3 s (the wake-up timer does).
  std::uint32_t now() {
    const InterruptLock lock;
    return counter_.advance(registers_.CURRENT);
  }

private:
  using Counter = MicrosCounter<kClockHz / 1'000'000>;
  SysTickRegisters& registers_;
  Counter counter_{0};
};

}  // namespace tessera::firmware::lm3s6965
