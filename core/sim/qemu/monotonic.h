// The real time that the emulator runs by. An edge to the machine: the logic gets its time as an argument.
#pragma once

#include <chrono>

#include "base/units.h"

namespace tessera::sim {

[[nodiscard]] inline Seconds monotonicNow() {
  return Seconds{std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count()};
}

}  // namespace tessera::sim
