#include "firmware/boards/lm3s6965/clock.h"

namespace tessera::firmware::lm3s6965 {
namespace {

constexpr std::uint32_t kRccBypass = 1U << 11;
constexpr std::uint32_t kRccPowerDown = 1U << 13;
constexpr std::uint32_t kRccUsePwmDivider = 1U << 20;
constexpr std::uint32_t kRccUseDivider = 1U << 22;
constexpr std::uint32_t kRccMainOscillatorOff = 1U << 0;
constexpr std::uint32_t kRccSourceMask = 3U << 4;
constexpr std::uint32_t kRccCrystalMask = 0xFU << 6;
constexpr std::uint32_t kRccCrystal8MHz = 0xEU << 6;
constexpr std::uint32_t kRccDividerMask = 0xFU << 23;
constexpr std::uint32_t kRccDivideBy4 = 3U << 23;  // 200 MHz / 4
constexpr std::uint32_t kRcc2UseRcc2 = 1U << 31;
constexpr std::uint32_t kPllLocked = 1U << 6;

constexpr std::uint32_t kRevisionMask = 0xFFFF;
constexpr std::uint32_t kRevisionA2 = 0x0002;
constexpr std::uint32_t kLdo2V75 = 0x1B;

// A pass takes at least four cycles of the 12 MHz internal oscillator: far more than the PLL's 0.5 ms.
constexpr std::uint32_t kLockPasses = 20'000;

}  // namespace

bool startClock(SystemControlRegisters& control) {
  // Errata of revision A2: the PLL is reliable only with the core's regulator at 2.75 V.
  if ((control.DID0 & kRevisionMask) == kRevisionA2) control.LDOPCTL = kLdo2V75;

  control.RCC2 = control.RCC2 & ~kRcc2UseRcc2;
  std::uint32_t rcc = (control.RCC | kRccBypass) & ~(kRccUseDivider | kRccUsePwmDivider);
  control.RCC = rcc;
  rcc &= ~(kRccCrystalMask | kRccSourceMask | kRccPowerDown | kRccMainOscillatorOff);
  rcc |= kRccCrystal8MHz;
  control.RCC = rcc;
  rcc = (rcc & ~kRccDividerMask) | kRccDivideBy4 | kRccUseDivider;
  control.RCC = rcc;
  for (std::uint32_t pass = 0; (control.RIS & kPllLocked) == 0; ++pass) {
    if (pass == kLockPasses) return false;
  }
  control.RCC = rcc & ~kRccBypass;
  return true;
}

void enablePeripherals(SystemControlRegisters& control) {
  constexpr std::uint32_t kWatchdog0 = 1U << 3, kPwm = 1U << 20;
  constexpr std::uint32_t kUart0 = 1U << 0, kUart1 = 1U << 1, kI2c0 = 1U << 12, kTimer0 = 1U << 16;
  constexpr std::uint32_t kPortsAToE = 0x1F;
  control.RCGC0 = control.RCGC0 | kWatchdog0 | kPwm;
  control.RCGC1 = control.RCGC1 | kUart0 | kUart1 | kI2c0 | kTimer0;
  control.RCGC2 = control.RCGC2 | kPortsAToE;
  // Three cycles must pass; reading the gates back takes longer.
  for (int i = 0; i < 3; ++i) static_cast<void>(control.RCGC2);
}

}  // namespace tessera::firmware::lm3s6965
