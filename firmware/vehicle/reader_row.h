// The reader bus: asks one reader after the other what it saw last, and the battery gauge once a second. Half duplex,
// the vehicle speaks first:
//
//   poll    0xB0 | node, complement of that                          2 bytes
//   answer  0xD0 | node, n, counter, n bytes, XOR of all before       n 0, 4, 7 or 10 (the UID)
//   gauge   node 15 answers with n = 2: millivolts, little-endian
//
// A node that does not answer within 8 ms is passed over; after three times it counts as missing.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "firmware/vehicle/board.h"
#include "firmware/vehicle/tag_log.h"
#include "firmware/vehicle/time.h"

namespace tessera::firmware {

class ReaderRow {
public:
  static constexpr std::uint32_t kBaud = 38400;

  explicit ReaderRow(Board& board) : board_{board} {}
  void start(int readers);

  /// Returns a reader's answer when one has just come in.
  std::optional<Reading> poll(Micros now);

  /// Bit i: reader i answers.
  [[nodiscard]] std::uint8_t answering() const { return answering_; }
  /// A reader has not answered three times running.
  [[nodiscard]] bool faulty() const { return missing_ != 0; }
  /// 0 while the gauge does not answer.
  [[nodiscard]] int batteryMillivolts() const { return millivolts_; }

private:
  static constexpr std::uint8_t kGauge = 15;
  static constexpr std::size_t kMaxAnswer = 14;

  void ask(Micros now);
  void next(Micros now);
  void failed();
  [[nodiscard]] bool takeByte(std::uint8_t byte);
  std::optional<Reading> answered();
  [[nodiscard]] std::size_t slotOf(std::uint8_t node) const { return node == kGauge ? TagLog::kMaxReaders : node; }

  Board& board_;
  std::uint8_t readers_ = 0;
  std::uint8_t node_ = 0;  ///< asked last
  std::uint8_t turn_ = 0;  ///< reader whose turn is next
  bool waiting_ = false;
  Micros asked_{0};
  Micros roundStart_{-1s};
  Micros gaugeAt_{0};
  std::array<std::uint8_t, kMaxAnswer> answer_{};
  std::size_t size_ = 0;
  std::array<std::uint8_t, TagLog::kMaxReaders + 1> failures_{};
  std::uint8_t answering_ = 0;
  std::uint8_t missing_ = 0;
  int millivolts_ = 0;
};

}  // namespace tessera::firmware
