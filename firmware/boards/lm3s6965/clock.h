// The system clock: 50 MHz from the 8 MHz crystal, and the gates that give the peripherals their share of it.
#pragma once

#include <cstdint>

#include "firmware/boards/lm3s6965/registers.h"

namespace tessera::firmware::lm3s6965 {

inline constexpr std::uint32_t kClockHz = 50'000'000;

/// Follows the data sheet's order (6.3): bypass, crystal, power the PLL, divider, wait for the lock, end the bypass.
/// False when the PLL does not lock within its bound, which is several times its specified 0.5 ms.
[[nodiscard]] bool startClock(SystemControlRegisters& control);

/// Gives clocks to what the board uses and waits the three cycles that the data sheet asks before the first access.
void enablePeripherals(SystemControlRegisters& control);

}  // namespace tessera::firmware::lm3s6965
