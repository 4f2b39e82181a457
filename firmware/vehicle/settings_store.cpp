#include "firmware/vehicle/settings_store.h"

#include <algorithm>

namespace tessera::firmware {
namespace {

// The chip may still be busy with a write that a restart has interrupted.
constexpr int kLoadTries = 10;
constexpr Micros kLoadRetry = 2ms;
constexpr int kWriteTries = 3;

std::uint16_t cellAddress(std::uint32_t start) {
  return static_cast<std::uint16_t>(kStartCells + (start % kStartCellCount) * kEepromPage);
}

}  // namespace

void SettingsStore::poll(Micros now) {
  eeprom_.poll(now);
  if (eeprom_.busy()) return;
  switch (state_) {
    case State::Load:
      load(now);
      break;
    case State::Count:
      eeprom_.write(cellAddress(starts_), encodeStartCell(starts_));
      state_ = State::CheckCount;
      break;
    case State::CheckCount:
      checkCount();
      break;
    case State::Ready:
      if (dirty_) startWriting();
      break;
    case State::Check:
      checkCopy();
      break;
  }
}

void SettingsStore::load(Micros now) {
  if (tries_ > 0 && now < nextTry_) return;
  nextTry_ = now + kLoadRetry;
  if (readAll()) {
    ++starts_;
    tries_ = 0;
    state_ = State::Count;
  } else if (++tries_ == kLoadTries) {
    starts_ = 0;
    written_ = false;
    state_ = State::Ready;
  }
}

// False when the chip does not answer; what it holds may be nothing.
bool SettingsStore::readAll() {
  starts_ = 0;
  for (std::uint32_t i = 0; i < kStartCellCount; ++i) {
    std::array<std::uint8_t, kStartCellSize> cell{};
    if (!eeprom_.read(cellAddress(i), cell)) return false;
    if (const auto count = decodeStartCell(cell)) starts_ = std::max(starts_, *count);
  }
  for (std::uint8_t copy = 0; copy < 2; ++copy) {
    std::array<std::uint8_t, kRecordRoom> bytes{};
    if (!eeprom_.read(kCopyAddress[copy], bytes)) return false;
    const auto record = decodeRecord(bytes);
    if (!record || (found_ && static_cast<std::int32_t>(record->sequence - sequence_) <= 0)) continue;
    found_ = true;
    settings_ = record->settings;
    sequence_ = record->sequence;
    copy_ = copy;
  }
  return true;
}

// A count that does not read back must not be used: the next start might choose the same one.
void SettingsStore::checkCount() {
  std::array<std::uint8_t, kStartCellSize> cell{};
  const bool good = !eeprom_.failed() && eeprom_.read(cellAddress(starts_), cell) && decodeStartCell(cell) == starts_;
  if (!good && ++tries_ < kWriteTries) {
    state_ = State::Count;
    return;
  }
  if (!good) {
    starts_ = 0;
    written_ = false;
  }
  tries_ = 0;
  state_ = State::Ready;
}

void SettingsStore::save(const Settings& settings) {
  settings_ = settings;
  dirty_ = true;
}

void SettingsStore::startWriting() {
  dirty_ = false;
  eeprom_.write(kCopyAddress[1 - copy_], encodeRecord({sequence_ + 1, settings_}));
  state_ = State::Check;
}

void SettingsStore::checkCopy() {
  std::array<std::uint8_t, kRecordSize> bytes{};
  const bool answered = !eeprom_.failed() && eeprom_.read(kCopyAddress[1 - copy_], bytes);
  const auto record = decodeRecord(bytes);
  state_ = State::Ready;
  written_ = answered && record && record->sequence == sequence_ + 1;
  if (written_) {
    found_ = true;
    copy_ = static_cast<std::uint8_t>(1 - copy_);
    ++sequence_;
    tries_ = 0;
  } else if (++tries_ < kWriteTries) {
    dirty_ = true;
  } else {
    tries_ = 0;
  }
}

}  // namespace tessera::firmware
