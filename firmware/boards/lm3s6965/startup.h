// What start-up leaves to the board: the stack's bounds, the mark of the last life, and how to end this one.
#pragma once

#include <cstdint>
#include <span>

#include "firmware/boards/lm3s6965/reset_cause.h"

namespace tessera::firmware::lm3s6965 {

[[nodiscard]] std::span<const volatile std::uint32_t> stackMemory();
/// Why this life began. Decided once, before the mark is set anew.
[[nodiscard]] wire::ResetCause startCause();
/// Leaves a mark for the next life and resets the processor.
[[noreturn]] void resetProcessor(LifeMark mark);

/// Served by the board once it stands; before that its interrupts are off.
void onPortA();
void onPortD();
void onUart0();
void onUart1();
void onWakeUp();

}  // namespace tessera::firmware::lm3s6965
