// The two serial ports and the clock of the emulated board.
#include <algorithm>

#include "emulated_board.h"

namespace tessera::sim {
namespace {

using QemuHostPorts = EmulatedBoard;

TEST_F(QemuHostPorts, bytesPassBothWaysOnBothPortsAtOnce) {
  start();
  std::vector<std::uint8_t> sent;
  for (int i = 0; i < 3000; ++i) sent.push_back(static_cast<std::uint8_t>(i * 7));
  std::vector<std::uint8_t> expected;
  for (std::uint8_t byte : sent) expected.push_back(static_cast<std::uint8_t>(byte + 1));
  std::size_t at = 0;
  // In pieces of a reader's answer, each sent when the one before has come back: the bus is half duplex.
  while (at < sent.size()) {
    const std::size_t n = std::min<std::size_t>(14, sent.size() - at);
    host_.fromReaders(std::span{sent}.subspan(at, n));
    at += n;
    if (at % 700 == 0) {
      EXPECT_EQ(ask("hello"), "hello");
    }
    ASSERT_TRUE(eventually([&] {
      collect();
      return onReaders_.size() >= at;
    })) << onReaders_.size();
  }
  EXPECT_EQ(onReaders_, expected);
}

TEST_F(QemuHostPorts, aLongAnswerArrivesWhole) {
  start();
  heard_.clear();
  say("say 20000");
  ASSERT_TRUE(eventually([&] {
    collect();
    return heard_.ends_with('\n');
  }));
  ASSERT_EQ(heard_.size(), 20001U);
  for (std::size_t i = 0; i < 20000; ++i) ASSERT_EQ(heard_[i], static_cast<char>('a' + i % 26)) << i;
}

TEST_F(QemuHostPorts, anAnswerThatNobodyFetchesDoesNotStopTheVehicle) {
  start();
  say("say 200000");
  std::this_thread::sleep_for(std::chrono::milliseconds{800});
  ask("hello");
  EXPECT_EQ(host_.resets(), 0);
  EXPECT_TRUE(host_.running());
}

TEST_F(QemuHostPorts, microsecondsRunWithTheWorldAcrossTheCountersWraps) {
  start();
  using Clock = std::chrono::steady_clock;
  const auto sample = [&] {
    const auto before = Clock::now();
    const long micros = askNumbers("micros").at(0);
    const auto after = Clock::now();
    return std::tuple{before, micros, after};
  };
  const auto [b0, m0, a0] = sample();
  long last = m0;
  const auto end = Clock::now() + std::chrono::milliseconds{1500};  // more than four wraps
  while (Clock::now() < end) {
    const long micros = askNumbers("micros").at(0);
    EXPECT_GE(micros, last);
    last = micros;
  }
  const auto [b1, m1, a1] = sample();
  const auto inMicros = [](Clock::duration d) { return std::chrono::duration<double, std::micro>(d).count(); };
  EXPECT_GT(static_cast<double>(m1 - m0), inMicros(b1 - a0) - 50.0);
  EXPECT_LT(static_cast<double>(m1 - m0), inMicros(a1 - b0) + 50.0);
}

TEST_F(QemuHostPorts, ticksComeAHundredTimesASecond) {
  start();
  const long m0 = askNumbers("micros").at(0);
  const long t0 = askNumbers("ticks").at(0);
  EXPECT_TRUE(eventually([&] { return askNumbers("micros").at(0) - m0 > 1'000'000; }));
  const long ticks = askNumbers("ticks").at(0) - t0;
  const double due = static_cast<double>(askNumbers("micros").at(0) - m0) / 10'000.0;
  // Late ones are dropped, never made up for; a busy computer may cost some.
  EXPECT_LE(static_cast<double>(ticks), due + 1.0);
  EXPECT_GE(static_cast<double>(ticks), due * 0.5);
}

}  // namespace
}  // namespace tessera::sim
