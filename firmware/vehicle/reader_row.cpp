#include "firmware/vehicle/reader_row.h"

#include <algorithm>

namespace tessera::firmware {
namespace {

constexpr std::uint8_t kPoll = 0xB0;
constexpr std::uint8_t kAnswer = 0xD0;
constexpr Micros kTimeout = 8ms;
constexpr Micros kRound = 10ms;  // readers try some ten times a second: asking faster brings nothing
constexpr Micros kGaugePeriod = 1s;
constexpr int kFailuresToMissing = 3;

bool plausibleLength(std::uint8_t n, bool gauge) { return gauge ? n == 2 : n == 0 || n == 4 || n == 7 || n == 10; }

}  // namespace

void ReaderRow::start(int readers) {
  readers_ = static_cast<std::uint8_t>(std::clamp<int>(readers, 1, TagLog::kMaxReaders));
  board_.setBaud(Uart::Readers, kBaud);
}

std::optional<Reading> ReaderRow::poll(Micros now) {
  std::array<std::uint8_t, 32> buffer{};
  const std::size_t n = board_.read(Uart::Readers, buffer);
  if (!waiting_) {
    next(now);
    return std::nullopt;
  }
  for (std::size_t i = 0; i < n; ++i)
    if (takeByte(buffer[i])) return answered();
  if (now - asked_ >= kTimeout) {
    failed();
    waiting_ = false;
  }
  return std::nullopt;
}

// Whose turn is it? The gauge once a second, otherwise the readers one after the other.
void ReaderRow::next(Micros now) {
  if (readers_ == 0) return;
  if (now >= gaugeAt_) {
    gaugeAt_ = now + kGaugePeriod;
    node_ = kGauge;
  } else {
    if (turn_ == 0) {
      if (now - roundStart_ < kRound) return;
      roundStart_ = now;
    }
    node_ = turn_;
    turn_ = static_cast<std::uint8_t>((turn_ + 1) % readers_);
  }
  ask(now);
}

void ReaderRow::ask(Micros now) {
  const auto head = static_cast<std::uint8_t>(kPoll | node_);
  const std::array<std::uint8_t, 2> poll{head, static_cast<std::uint8_t>(~head)};
  board_.write(Uart::Readers, poll);
  size_ = 0;
  asked_ = now;
  waiting_ = true;
}

// True when a whole, undamaged answer of the node that was asked has come in. What cannot be its start is passed over.
bool ReaderRow::takeByte(std::uint8_t byte) {
  answer_[size_++] = byte;
  if (answer_[0] != (kAnswer | node_) || (size_ > 1 && !plausibleLength(answer_[1], node_ == kGauge))) {
    size_ = 0;
    return false;
  }
  if (size_ < 2) return false;
  const std::size_t whole = std::size_t{answer_[1]} + 4;
  if (size_ < whole) return false;
  std::uint8_t sum = 0;
  for (std::size_t i = 0; i < whole; ++i) sum ^= answer_[i];
  size_ = 0;
  return sum == 0;
}

std::optional<Reading> ReaderRow::answered() {
  waiting_ = false;
  failures_[slotOf(node_)] = 0;
  if (node_ == kGauge) {
    millivolts_ = answer_[3] | answer_[4] << 8;
    return std::nullopt;
  }
  const auto bit = static_cast<std::uint8_t>(1U << node_);
  answering_ |= bit;
  missing_ = static_cast<std::uint8_t>(missing_ & ~bit);
  Reading reading;
  reading.reader = node_;
  reading.length = answer_[1];
  reading.counter = answer_[2];
  std::copy_n(answer_.begin() + 3, reading.length, reading.uid.begin());
  return reading;
}

void ReaderRow::failed() {
  std::uint8_t& failures = failures_[slotOf(node_)];
  if (failures < kFailuresToMissing && ++failures < kFailuresToMissing) return;
  if (node_ == kGauge) {
    millivolts_ = 0;
    return;
  }
  const auto bit = static_cast<std::uint8_t>(1U << node_);
  missing_ |= bit;
  answering_ = static_cast<std::uint8_t>(answering_ & ~bit);
}

}  // namespace tessera::firmware
