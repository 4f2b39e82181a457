// The chips around the firmware, as their data sheets say they behave: EEPROM, compass, radio module.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "firmware/vehicle/board.h"
#include "firmware/vehicle/settings.h"

namespace tessera::firmware::test {

/// AT24C32: does not acknowledge during a write cycle; a power cut may come after any byte.
class FakeEeprom {
public:
  std::array<std::uint8_t, kEepromSize> cells;
  bool present = true;
  std::uint64_t busyUntil = 0;
  std::vector<std::size_t> pageWrites = std::vector<std::size_t>(kEepromSize / kEepromPage);
  /// After this many more bytes the power goes: the byte's page then holds rubbish from there on.
  std::optional<std::size_t> bytesToPowerCut;
  bool powerCut = false;

  FakeEeprom() { cells.fill(0xFF); }

  bool write(std::span<const std::uint8_t> data, std::uint64_t now) {
    if (!present || powerCut || now < busyUntil || data.size() < 2) return false;
    pointer_ = static_cast<std::size_t>(data[0] << 8 | data[1]) % kEepromSize;
    const std::size_t page = pointer_ / kEepromPage * kEepromPage;
    if (data.size() == 2) return true;
    ++pageWrites[page / kEepromPage];
    for (std::uint8_t byte : data.subspan(2)) {
      if (bytesToPowerCut && (*bytesToPowerCut)-- == 0) {
        powerCut = true;
        for (std::size_t i = pointer_; i < page + kEepromPage; ++i) cells[i] = static_cast<std::uint8_t>(0x5A ^ i);
        return false;
      }
      cells[pointer_] = byte;
      pointer_ = page + (pointer_ + 1) % kEepromPage;
    }
    busyUntil = now + 5000;
    return true;
  }
  bool read(std::span<std::uint8_t> out, std::uint64_t now) {
    if (!present || powerCut || now < busyUntil) return false;
    for (std::uint8_t& byte : out) {
      byte = cells[pointer_];
      pointer_ = (pointer_ + 1) % kEepromSize;
    }
    return true;
  }

private:
  std::size_t pointer_ = 0;
};

/// HMC5883L in a field given in µT along its axes.
class FakeCompass {
public:
  bool present = true;
  std::array<double, 3> field{80.0, 60.0, 40.0};
  std::array<std::uint8_t, 3> id{'H', '4', '3'};
  int configurations = 0;

  bool write(std::span<const std::uint8_t> data) {
    if (!present || data.empty()) return false;
    pointer_ = data[0];
    if (data.size() == 2 && pointer_ < registers_.size()) {
      registers_[pointer_] = data[1];
      if (pointer_ == 2) ++configurations;
    }
    return true;
  }
  bool read(std::span<std::uint8_t> out) {
    if (!present) return false;
    for (std::uint8_t& byte : out) byte = at(pointer_++);
    return true;
  }
  [[nodiscard]] unsigned gain() const { return registers_[1] >> 5; }

private:
  std::uint8_t at(std::size_t reg) {
    static constexpr double perGauss[] = {1370, 1090, 820, 660, 440, 390, 330, 230};
    static constexpr std::size_t order[] = {0, 2, 1};
    if (reg < 3) return registers_[reg];
    if (reg >= 10 && reg < 13) return id[reg - 10];
    if (reg >= 9) return 0;
    const double counts = std::round(field[order[(reg - 3) / 2]] / 100.0 * perGauss[gain()]);
    const auto value = static_cast<std::int16_t>(std::fabs(counts) > 2047 ? -4096 : counts);
    return static_cast<std::uint8_t>((reg - 3) % 2 == 0 ? static_cast<std::uint16_t>(value) >> 8 : value);
  }
  std::array<std::uint8_t, 3> registers_{0x10, 0x20, 0x01};
  std::size_t pointer_ = 0;
};

/// The E32's configuration mode: answers C1 C1 C1 with its registers, takes C0 ADDH ADDL SPED CHAN OPTION.
class FakeE32 {
public:
  std::array<std::uint8_t, 6> registers{0xC0, 0, 0, 0x1A, 0x17, 0x44};  // as delivered: 9600 baud, 2.4k, channel 23
  bool present = true;
  bool stubborn = false;  ///< takes no parameters
  int writes = 0;

  std::vector<std::uint8_t> configure(std::span<const std::uint8_t> data) {
    if (!present) return {};
    if (data.size() == 3 && std::all_of(data.begin(), data.end(), [](auto b) { return b == 0xC1; }))
      return {registers.begin(), registers.end()};
    if (data.size() == 6 && data[0] == 0xC0) {
      ++writes;
      if (!stubborn) std::copy(data.begin(), data.end(), registers.begin());
    }
    return {};
  }
};

}  // namespace tessera::firmware::test
