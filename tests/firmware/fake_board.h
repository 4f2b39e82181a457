// A board for tests: time, bytes, pins and chips in the test's hands.
#pragma once

#include <utility>

#include "tests/firmware/fake_chips.h"

namespace tessera::firmware::test {

class FakeBoard final : public Board {
public:
  std::uint64_t time = 0;  ///< µs
  FakeEeprom memory;
  FakeCompass compass;
  FakeE32 e32;
  std::array<std::deque<std::uint8_t>, 2> incoming;
  std::array<std::vector<std::uint8_t>, 2> outgoing;
  std::array<std::uint32_t, 2> baud{};
  RadioMode mode = RadioMode::Normal;
  bool aux = true;
  std::array<int, 2> duty{};
  std::array<std::int32_t, 2> encoder{};
  std::array<std::uint32_t, kRangers> echoes{38'000, 38'000};  ///< µs; nothing in reach. 0: a ranger that is dead
  std::array<std::vector<std::uint64_t>, kRangers> pings;
  int fed = 0;
  int restarts = 0;
  wire::ResetCause cause = wire::ResetCause::PowerOn;

  std::uint32_t micros() override { return static_cast<std::uint32_t>(time); }
  std::size_t read(Uart port, std::span<std::uint8_t> out) override {
    auto& in = incoming[static_cast<std::size_t>(port)];
    const std::size_t n = std::min(out.size(), in.size());
    std::copy_n(in.begin(), n, out.begin());
    in.erase(in.begin(), in.begin() + static_cast<std::ptrdiff_t>(n));
    return n;
  }
  std::size_t write(Uart port, std::span<const std::uint8_t> data) override {
    if (port == Uart::Radio && mode == RadioMode::Configure) {
      const auto answer = baud[0] == 9600 ? e32.configure(data) : std::vector<std::uint8_t>{};
      incoming[0].insert(incoming[0].end(), answer.begin(), answer.end());
      return data.size();
    }
    auto& out = outgoing[static_cast<std::size_t>(port)];
    out.insert(out.end(), data.begin(), data.end());
    return data.size();
  }
  bool sent(Uart) override { return true; }
  void setBaud(Uart port, std::uint32_t rate) override { baud[static_cast<std::size_t>(port)] = rate; }
  void setRadioMode(RadioMode m) override { mode = m; }
  bool radioReady() override { return aux; }
  bool i2cWrite(std::uint8_t address, std::span<const std::uint8_t> data) override {
    if (address == 0x50) return memory.write(data, time);
    return address == 0x1E && compass.write(data);
  }
  bool i2cRead(std::uint8_t address, std::span<std::uint8_t> out) override {
    if (address == 0x50) return memory.read(out, time);
    return address == 0x1E && compass.read(out);
  }
  void drive(Wheel wheel, std::int16_t permille) override { duty[static_cast<std::size_t>(wheel)] = permille; }
  std::int32_t counts(Wheel wheel) override { return encoder[static_cast<std::size_t>(wheel)]; }
  void ping(std::size_t ranger) override { pings[ranger].push_back(time); }
  std::uint32_t echo(std::size_t ranger) override { return echoes[ranger]; }
  void feedWatchdog() override { ++fed; }
  wire::ResetCause resetCause() override { return cause; }
  void restart() override { ++restarts; }
  std::uint8_t hardware() override { return 255; }
  std::uint32_t stackFree() override { return 1234; }

  std::vector<std::uint8_t> takeOutgoing(Uart port) {
    return std::exchange(outgoing[static_cast<std::size_t>(port)], {});
  }
};

}  // namespace tessera::firmware::test
