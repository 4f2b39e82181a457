#include "firmware/boards/lm3s6965/i2c_master.h"

#include "firmware/boards/lm3s6965/clock.h"

namespace tessera::firmware::lm3s6965 {
namespace {

// Written to MCS: commands. Read from MCS: status.
constexpr std::uint32_t kRun = 1U << 0, kStart = 1U << 1, kStop = 1U << 2, kAcknowledge = 1U << 3;
constexpr std::uint32_t kBusy = 1U << 0, kError = 1U << 1, kLostArbitration = 1U << 4, kBusBusy = 1U << 6;
constexpr std::uint32_t kMasterEnable = 1U << 4;

// SCL = clock / (20 * (TPR + 1)): 357 kHz, the fastest not above the parts' 400 kHz.
constexpr std::uint32_t kTimerPeriod = (kClockHz + 20 * 400'000 - 1) / (20 * 400'000) - 1;
// A byte takes 25 µs, and a part may stretch the clock a little. One pass takes at least 8 cycles: 160 µs in all.
// Counted in passes, not in time, so that a pause of the whole processor is no failure.
constexpr int kPasses = 1000;

}  // namespace

I2cMaster::I2cMaster(I2cRegisters& registers) : registers_{registers} {
  registers_.MCR = kMasterEnable;
  registers_.MTPR = kTimerPeriod;
  registers_.MIMR = 0;
}

bool I2cMaster::write(std::uint8_t address, std::span<const std::uint8_t> data) {
  if (data.empty() || !busFree()) return false;
  registers_.MSA = std::uint32_t{address} << 1;
  for (std::size_t i = 0; i < data.size(); ++i) {
    registers_.MDR = data[i];
    const std::uint32_t begin = i == 0 ? kStart : 0;
    const std::uint32_t end = i + 1 == data.size() ? kStop : 0;
    if (!step(kRun | begin | end)) return false;
  }
  return true;
}

bool I2cMaster::read(std::uint8_t address, std::span<std::uint8_t> out) {
  if (out.empty() || !busFree()) return false;
  registers_.MSA = std::uint32_t{address} << 1 | 1U;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::uint32_t begin = i == 0 ? kStart : 0;
    const std::uint32_t end = i + 1 == out.size() ? kStop : kAcknowledge;
    if (!step(kRun | begin | end)) return false;
    out[i] = static_cast<std::uint8_t>(registers_.MDR);
  }
  return true;
}

bool I2cMaster::busFree() {
  // After a STOP the bus stays busy for the few µs of the stop condition.
  return waitWhile(kBusBusy);
}

bool I2cMaster::step(std::uint32_t command) {
  registers_.MCS = command;
  // The data sheet allows BUSY to rise a few cycles after the command: one read lies between.
  static_cast<void>(registers_.MCS);
  if (!waitWhile(kBusy)) {
    abandon();
    return false;
  }
  if ((registers_.MCS & kError) == 0) return true;
  if ((command & kStop) == 0 && (registers_.MCS & kLostArbitration) == 0) {
    registers_.MCS = kStop;
    static_cast<void>(waitWhile(kBusy));
  }
  return false;
}

bool I2cMaster::waitWhile(std::uint32_t status) {
  for (int pass = 0; pass < kPasses; ++pass) {
    if ((registers_.MCS & status) == 0) return true;
  }
  return false;
}

void I2cMaster::abandon() {
  registers_.MCR = 0;
  registers_.MCR = kMasterEnable;
  registers_.MTPR = kTimerPeriod;
}

}  // namespace tessera::firmware::lm3s6965
