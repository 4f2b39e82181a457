// AT24C32-class EEPROM on the I2C bus (two address bytes, pages of 32 bytes, 5 ms for a write cycle, during which the
// chip does not acknowledge). Nothing waits: a write is split into pages and carried on with each poll.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/vehicle/board.h"
#include "firmware/vehicle/time.h"

namespace tessera::firmware {

class Eeprom {
public:
  static constexpr std::uint8_t kAddress = 0x50;
  static constexpr std::size_t kMaxWrite = 128;

  explicit Eeprom(Board& board) : board_{board} {}

  /// Reads at once (22 µs a byte at 400 kHz). False while a write is under way, or when the chip does not answer.
  bool read(std::uint16_t address, std::span<std::uint8_t> out);
  /// Takes up to kMaxWrite bytes for writing. False while another write is under way, or when there are too many.
  bool write(std::uint16_t address, std::span<const std::uint8_t> data);
  /// Carries a write on by at most one page.
  void poll(Micros now);

  [[nodiscard]] bool busy() const { return state_ != State::Idle; }
  /// The last write ended because the chip did not answer in time.
  [[nodiscard]] bool failed() const { return failed_; }

private:
  enum class State : std::uint8_t { Idle, Writing, Settling };
  bool writePage();

  Board& board_;
  std::array<std::uint8_t, kMaxWrite> data_{};
  std::size_t size_ = 0;
  std::size_t done_ = 0;
  std::uint16_t address_ = 0;
  State state_ = State::Idle;
  bool failed_ = false;
  bool timing_ = false;  ///< nextTry_ and giveUp_ are set
  Micros nextTry_{0};
  Micros giveUp_{0};
};

}  // namespace tessera::firmware
