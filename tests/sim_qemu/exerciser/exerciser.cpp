// A program for the LM3S6965 that does with its board what a test asks for, one text line each over the radio's port.
// Every line is answered by one line. Bytes on the readers' port come back there, each one higher by one.
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "firmware/boards/lm3s6965/board.h"

namespace {

using namespace tessera::firmware;
using Board = lm3s6965::Lm3s6965Board;

/// A line under construction; what does not fit is cut.
class Text {
public:
  Text& operator<<(std::string_view s) {
    for (char c : s) put(c);
    return *this;
  }
  Text& operator<<(std::int32_t v) {
    if (v < 0) put('-');
    std::uint32_t rest = v < 0 ? 0U - static_cast<std::uint32_t>(v) : static_cast<std::uint32_t>(v);
    std::array<char, 10> digits{};
    std::size_t n = 0;
    do {
      digits[n++] = static_cast<char>('0' + rest % 10);
      rest /= 10;
    } while (rest != 0);
    while (n > 0) put(digits[--n]);
    return *this;
  }
  Text& operator<<(std::uint32_t v) { return *this << static_cast<std::int32_t>(v & 0x7FFFFFFF); }
  [[nodiscard]] std::span<const std::uint8_t> bytes() const { return {data_.data(), size_}; }

private:
  void put(char c) {
    if (size_ < data_.size()) data_[size_++] = static_cast<std::uint8_t>(c);
  }
  std::array<std::uint8_t, 200> data_{};
  std::size_t size_ = 0;
};

/// Words of a line, separated by single blanks.
class Words {
public:
  explicit Words(std::string_view line) : rest_{line} {}
  std::string_view word() {
    const std::size_t end = rest_.find(' ');
    const std::string_view found = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
    return found;
  }
  std::int32_t number() {
    std::string_view digits = word();
    const bool negative = !digits.empty() && digits.front() == '-';
    if (negative) digits.remove_prefix(1);
    std::int32_t value = 0;
    for (char c : digits) value = value * 10 + (c - '0');
    return negative ? -value : value;
  }
  [[nodiscard]] bool more() const { return !rest_.empty(); }

private:
  std::string_view rest_;
};

class Exerciser {
public:
  explicit Exerciser(Board& board) : board_{board} { board_.setBaud(Uart::Radio, 115200); }

  void poll() {
    if (!hung_) board_.feedWatchdog();
    std::array<std::uint8_t, 32> in{};
    const std::size_t n = board_.read(Uart::Readers, in);
    for (std::uint8_t& byte : std::span{in}.first(n)) ++byte;
    board_.write(Uart::Readers, std::span{in}.first(n));
    const std::size_t m = board_.read(Uart::Radio, in);
    for (std::uint8_t byte : std::span{in}.first(m)) take(static_cast<char>(byte));
  }
  void tick() { ++ticks_; }

private:
  void take(char c) {
    if (c != '\n') {
      if (size_ < line_.size()) line_[size_++] = c;
      return;
    }
    Text answer;
    obey(Words{std::string_view{line_.data(), size_}}, answer);
    size_ = 0;
    answer << "\n";
    board_.write(Uart::Radio, answer.bytes());
  }

  void obey(Words words, Text& out) {
    const std::string_view verb = words.word();
    if (verb == "hello") out << "hello";
    if (verb == "cause") out << static_cast<std::int32_t>(board_.resetCause());
    if (verb == "micros") out << board_.micros();
    if (verb == "ticks") out << ticks_;
    if (verb == "stack") out << board_.stackFree();
    if (verb == "counts") out << board_.counts(Wheel::Left) << " " << board_.counts(Wheel::Right);
    if (verb == "aux") out << std::int32_t{board_.radioReady()};
    if (verb == "mode") board_.setRadioMode(static_cast<RadioMode>(words.number()));
    if (verb == "drive") drive(words);
    if (verb == "ping") board_.ping(static_cast<std::size_t>(words.number()));
    if (verb == "echo") out << board_.echo(static_cast<std::size_t>(words.number()));
    if (verb == "write") write(words, out);
    if (verb == "read") read(words, out);
    if (verb == "say") say(static_cast<std::uint32_t>(words.number()));
    if (verb == "hang") hung_ = true;
    if (verb == "restart") board_.restart();
    if (verb == "fault") asm volatile("udf #0");
  }

  void drive(Words& words) {
    const std::int32_t left = words.number();
    board_.drive(Wheel::Left, static_cast<std::int16_t>(left));
    board_.drive(Wheel::Right, static_cast<std::int16_t>(words.number()));
  }

  /// write ADDRESS BYTE...: one I2C transfer.
  void write(Words& words, Text& out) {
    const auto address = static_cast<std::uint8_t>(words.number());
    std::array<std::uint8_t, 34> data{};
    std::size_t n = 0;
    while (words.more() && n < data.size()) data[n++] = static_cast<std::uint8_t>(words.number());
    out << (board_.i2cWrite(address, std::span{data}.first(n)) ? "done" : "no answer");
  }

  /// read ADDRESS COUNT: one I2C transfer.
  void read(Words& words, Text& out) {
    const auto address = static_cast<std::uint8_t>(words.number());
    std::array<std::uint8_t, 34> data{};
    const auto asked = static_cast<std::size_t>(words.number());
    const std::span<std::uint8_t> part = std::span{data}.first(asked < data.size() ? asked : data.size());
    if (!board_.i2cRead(address, part)) {
      out << "no answer";
      return;
    }
    for (std::uint8_t byte : part) out << std::int32_t{byte} << " ";
  }

  /// say COUNT: that many bytes, as fast as the port takes them, then the empty answer line.
  void say(std::uint32_t count) {
    for (std::uint32_t i = 0; i < count;) {
      const std::array<std::uint8_t, 1> byte = {static_cast<std::uint8_t>('a' + i % 26)};
      if (board_.write(Uart::Radio, byte) == 1) ++i;
      board_.feedWatchdog();
    }
  }

  Board& board_;
  std::array<char, 160> line_{};
  std::size_t size_ = 0;
  std::int32_t ticks_ = 0;
  bool hung_ = false;
};

Board board;
Exerciser exerciser{board};

}  // namespace

int main() {
  for (;;) {
    exerciser.poll();
    if (board.tickDue()) exerciser.tick();
    board.idle();
  }
}
