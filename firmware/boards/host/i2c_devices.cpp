#include "firmware/boards/host/i2c_devices.h"

#include <algorithm>
#include <cmath>

namespace tessera::firmware {
namespace {

constexpr std::uint8_t kModeRegister = 2;
constexpr std::uint8_t kFirstData = 3;
constexpr std::uint8_t kLastData = 8;
constexpr std::uint8_t kStatus = 9;
constexpr std::uint8_t kReady = 0x01;
constexpr std::uint8_t kLocked = 0x02;
constexpr std::uint64_t kSingleTime = 6000;  // µs
constexpr int kOverflow = -4096;
constexpr double kMicroteslaPerGauss = 100.0;
constexpr std::array<double, 8> kCountsPerGauss{1370, 1090, 820, 660, 440, 390, 330, 230};
// CRA bits 4 to 2; the last code is reserved and taken for the fastest rate.
constexpr std::array<double, 8> kRate{0.75, 1.5, 3, 7.5, 15, 30, 75, 75};

std::uint64_t periodOf(std::uint8_t configuration) {
  return static_cast<std::uint64_t>(std::lround(1e6 / kRate[(configuration >> 2U) & 7U]));
}

}  // namespace

void CompassChip::powerOn(std::uint64_t now) {
  registers_ = {0x10, 0x20, 0x01, 0, 0, 0, 0, 0, 0, 0, 'H', '4', '3'};
  pointer_ = 0;
  unread_ = 0;
  gain_ = 1;
  // The data sheet's default of the mode register is "single": one measurement, then idle.
  measuring_ = true;
  due_ = now + kSingleTime;
}

void CompassChip::setRegister(std::uint8_t index, std::uint8_t value, std::uint64_t now) {
  if (index > kModeRegister) return;  // data, status and identification cannot be written
  registers_[index] = value;
  if (index != kModeRegister) return;
  const unsigned mode = value & 3U;
  measuring_ = mode < 2;
  due_ = now + (mode == 0 ? periodOf(registers_[0]) : kSingleTime);
  unread_ = 0;  // a write to the mode register lifts the lock
  registers_[kStatus] = 0;
}

void CompassChip::step(std::uint64_t now, const ChipField& field) {
  if (!measuring_ || now < due_) return;
  measure(field);
  if ((registers_[kModeRegister] & 3U) == 0) {
    const std::uint64_t period = periodOf(registers_[0]);
    due_ += period * ((now - due_) / period + 1);
  } else {
    measuring_ = false;
    registers_[kModeRegister] = static_cast<std::uint8_t>((registers_[kModeRegister] & ~3U) | 2U);
  }
}

void CompassChip::measure(const ChipField& field) {
  const double perMicrotesla = kCountsPerGauss[gain_] / kMicroteslaPerGauss;
  gain_ = static_cast<std::uint8_t>(registers_[1] >> 5U);
  if (unread_ != 0 && unread_ != 6) return;  // locked: someone is half way through the last result
  const std::array<double, 3> order{field[0], field[2], field[1]};
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double counts = std::round(order[i] * perMicrotesla);
    const int value = counts < -2048 || counts > 2047 ? kOverflow : static_cast<int>(counts);
    registers_[kFirstData + 2 * i] = static_cast<std::uint8_t>(static_cast<unsigned>(value) >> 8U);
    registers_[kFirstData + 2 * i + 1] = static_cast<std::uint8_t>(value);
  }
  unread_ = 6;
  registers_[kStatus] = kReady;
}

bool CompassChip::write(std::span<const std::uint8_t> data, std::uint64_t now) {
  if (data.empty()) return true;
  pointer_ = data[0];
  for (const std::uint8_t value : data.subspan(1)) setRegister(pointer_++, value, now);
  return true;
}

bool CompassChip::read(std::span<std::uint8_t> out) {
  for (std::uint8_t& byte : out) {
    byte = pointer_ < registers_.size() ? registers_[pointer_] : 0;
    if (pointer_ >= kFirstData && pointer_ <= kLastData && unread_ > 0) {
      --unread_;
      registers_[kStatus] = unread_ == 0 ? 0 : kReady | kLocked;
    }
    if (pointer_ == kLastData)
      pointer_ = kFirstData;
    else
      pointer_ = pointer_ + 1U < registers_.size() ? static_cast<std::uint8_t>(pointer_ + 1) : std::uint8_t{0};
  }
  return true;
}

bool EepromChip::write(std::span<const std::uint8_t> data, std::uint64_t now) {
  if (now < busyUntil_) return false;
  if (data.size() < 2) return true;  // half an address: the STOP makes the chip forget it
  pointer_ = (std::size_t{data[0]} * 256 + data[1]) % kSize;
  const std::size_t page = pointer_ / kPage * kPage;
  for (const std::uint8_t value : data.subspan(2)) {
    cells_[pointer_] = value;
    pointer_ = page + (pointer_ + 1) % kPage;  // rolls over inside the page
  }
  if (data.size() > 2) busyUntil_ = now + kWriteCycle;
  return true;
}

bool EepromChip::read(std::span<std::uint8_t> out, std::uint64_t now) {
  if (now < busyUntil_) return false;
  for (std::uint8_t& byte : out) {
    byte = cells_[pointer_];
    pointer_ = (pointer_ + 1) % kSize;
  }
  return true;
}

}  // namespace tessera::firmware
