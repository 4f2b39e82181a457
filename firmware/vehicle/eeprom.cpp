#include "firmware/vehicle/eeprom.h"

#include <algorithm>

#include "firmware/vehicle/settings.h"

namespace tessera::firmware {
namespace {

constexpr Micros kAckPollPeriod = 500us;
constexpr Micros kCyclePatience = 25ms;  // five write cycles

static_assert(kRecordSize <= Eeprom::kMaxWrite);

}  // namespace

bool Eeprom::read(std::uint16_t address, std::span<std::uint8_t> out) {
  if (busy()) return false;
  const std::array<std::uint8_t, 2> pointer{static_cast<std::uint8_t>(address >> 8),
                                            static_cast<std::uint8_t>(address)};
  return board_.i2cWrite(kAddress, pointer) && board_.i2cRead(kAddress, out);
}

bool Eeprom::write(std::uint16_t address, std::span<const std::uint8_t> data) {
  if (busy() || data.size() > data_.size()) return false;
  std::copy(data.begin(), data.end(), data_.begin());
  size_ = data.size();
  done_ = 0;
  address_ = address;
  state_ = State::Writing;
  failed_ = false;
  timing_ = false;
  return true;
}

void Eeprom::poll(Micros now) {
  if (!busy()) return;
  if (!timing_) {
    nextTry_ = now;
    giveUp_ = now + kCyclePatience;
    timing_ = true;
  }
  if (now < nextTry_) return;
  nextTry_ = now + kAckPollPeriod;
  if (writePage()) {
    giveUp_ = now + kCyclePatience;
  } else if (now >= giveUp_) {
    failed_ = true;
    state_ = State::Idle;
  }
}

// Sends what still fits into the current page; with nothing left, asks whether the last write cycle has ended.
bool Eeprom::writePage() {
  const std::size_t at = address_ + done_;
  const std::size_t length = std::min(size_ - done_, kEepromPage - at % kEepromPage);
  std::array<std::uint8_t, kEepromPage + 2> out{};
  out[0] = static_cast<std::uint8_t>(at >> 8);
  out[1] = static_cast<std::uint8_t>(at);
  std::copy_n(data_.begin() + static_cast<std::ptrdiff_t>(done_), length, out.begin() + 2);
  if (!board_.i2cWrite(kAddress, std::span{out}.first(length + 2))) return false;
  done_ += length;
  if (state_ == State::Settling)
    state_ = State::Idle;
  else if (done_ == size_)
    state_ = State::Settling;
  return true;
}

}  // namespace tessera::firmware
