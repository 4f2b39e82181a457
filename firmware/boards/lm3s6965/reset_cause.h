// Why the processor started: from the reset cause register, and from a mark in memory that survives every reset but
// loss of power, for controllers (and emulators) whose register stays silent.
#pragma once

#include <cstdint>

#include "wire/messages.h"

namespace tessera::firmware::lm3s6965 {

/// Values that memory does not show by chance after power-on.
enum class LifeMark : std::uint32_t {
  Running = 0x52554E21,  ///< the program ran and had no intention to end
  Restart = 0x52535421,  ///< the program asked for the reset itself
  Fault = 0x464C5421,    ///< the processor met a fault
};

/// `resc` is SYSCTL.RESC: external 0, power-on 1, brown-out 2, watchdog 3, software 4. Its bits collect until cleared,
/// so after a loss of power the others mean nothing.
[[nodiscard]] constexpr wire::ResetCause decideResetCause(std::uint32_t resc, std::uint32_t mark) {
  if ((resc & 0b110U) != 0) return wire::ResetCause::PowerOn;
  if ((resc & 1U << 3) != 0) return wire::ResetCause::Watchdog;
  const bool fault = mark == static_cast<std::uint32_t>(LifeMark::Fault);
  if ((resc & 1U << 4) != 0) return fault ? wire::ResetCause::Other : wire::ResetCause::Software;
  if (resc != 0 || fault) return wire::ResetCause::Other;
  if (mark == static_cast<std::uint32_t>(LifeMark::Restart)) return wire::ResetCause::Software;
  if (mark == static_cast<std::uint32_t>(LifeMark::Running)) return wire::ResetCause::Watchdog;
  return wire::ResetCause::PowerOn;
}

}  // namespace tessera::firmware::lm3s6965
