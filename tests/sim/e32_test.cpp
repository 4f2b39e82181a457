#include "sim/e32.h"

#include <gtest/gtest.h>

#include <numeric>

namespace tessera::sim {
namespace {

using firmware::RadioMode;
using Bytes = std::vector<std::uint8_t>;

Bytes count(std::size_t n) {
  Bytes b(n);
  std::iota(b.begin(), b.end(), std::uint8_t{0});
  return b;
}

/// Two modules on a channel without losses, run in steps of a tenth of a millisecond.
class E32Test : public ::testing::Test {
protected:
  static constexpr double kStep = 0.0001;
  static constexpr double kByte = 10.0 / 115200;

  void run(double seconds) {
    const auto steps = static_cast<int>(seconds / kStep + 0.5);
    for (int i = 0; i < steps; ++i) step();
  }
  void step() {
    now += Seconds{kStep};
    a.advance(now);
    b.advance(now);
    for (const auto& d : air.settle(now)) (d.module == a.module() ? a : b).receive(d.packet, d.at);
    for (const auto byte : a.takeUart(now)) fromA.push_back(byte);
    for (const auto byte : b.takeUart(now)) fromB.push_back(byte);
  }
  /// Until the pin has the level; how long it took. Gives up after five seconds.
  double until(const E32& module, bool ready) {
    const Seconds start = now;
    while (module.ready() != ready && now - start < Seconds{5}) step();
    return (now - start).value();
  }
  /// Waits as the data sheet asks.
  void change(E32& module, RadioMode mode) {
    module.setMode(mode, now);
    run(0.001);
    until(module, true);
    run(0.002);
  }

  Air air{{1.0, 0.0, Seconds{}}, RandomStream{1, "air"}};
  E32Registers fast = E32Registers::of(23, 5, 115200);
  E32 a{air, fast};
  E32 b{air, fast};
  Seconds now;
  Bytes fromA;
  Bytes fromB;
};

TEST_F(E32Test, carriesAFrameInTheTimeThatItsPartsTake) {
  a.fromUart(count(20), now);
  while (fromB.empty() && now < Seconds{1}) step();
  const double first = 20 * kByte + 3 * kByte + timeOnAir(5, 20).value() + 0.005 + kByte;
  EXPECT_NEAR(now.value(), first, kStep);
  run(19 * kByte + kStep);
  EXPECT_EQ(fromB, count(20));
  EXPECT_TRUE(fromA.empty());
}

TEST_F(E32Test, splitsWhatIsLongerThanAPacket) {
  a.fromUart(count(130), now);
  run(0.5);
  EXPECT_EQ(a.counters().sent, 3U);
  EXPECT_EQ(fromB, count(130));
}

TEST_F(E32Test, sendsAWholePacketWithoutWaitingForSilence) {
  a.fromUart(count(58), now);
  run(58 * kByte + kStep);
  EXPECT_EQ(a.counters().sent, 1U);
}

TEST_F(E32Test, joinsBytesAcrossAPauseShorterThanThreeByteTimes) {
  a.fromUart(count(5), now);
  run(5 * kByte + 2 * kByte);
  a.fromUart(count(5), now);
  run(0.2);
  EXPECT_EQ(a.counters().sent, 1U);
  a.fromUart(count(5), now);
  run(5 * kByte + 5 * kByte);
  a.fromUart(count(5), now);
  run(0.2);
  EXPECT_EQ(a.counters().sent, 3U);
}

TEST_F(E32Test, doesNotTakeTheStepsOfAHandOverForSilence) {
  E32 slow{air, fast, Seconds{0.001}};
  slow.fromUart(count(2), Seconds{1.000});
  slow.advance(Seconds{1.001});
  slow.fromUart(count(20), Seconds{1.001});
  for (int i = 2; i < 50; ++i) slow.advance(Seconds{1.0 + i * 0.001});
  EXPECT_EQ(slow.counters().sent, 1U);
}

TEST_F(E32Test, keepsHalfAKilobyteAndDropsTheRest) {
  // The air takes far longer than the UART: 512 wait, and one packet after the other leaves.
  a.fromUart(Bytes(2000, 1), now);
  run(2000 * kByte + 0.01);
  EXPECT_GT(a.counters().overflow, 1000U);
  run(3.0);
  EXPECT_EQ(fromB.size() + a.counters().overflow, 2000U);
  EXPECT_GE(fromB.size(), E32::kBuffer);
}

TEST_F(E32Test, lowersAuxAtTheFirstByteAndRaisesItWhenTheLastPacketStarts) {
  EXPECT_TRUE(a.ready());
  a.fromUart(count(70), now);
  EXPECT_FALSE(a.ready());
  const double low = until(a, true);
  EXPECT_NEAR(low, 58 * kByte + timeOnAir(5, 58).value(), 2 * kStep);
  EXPECT_EQ(a.counters().sent, 2U);
}

TEST_F(E32Test, lowersAuxFiveMillisecondsBeforeReceivedBytes) {
  a.fromUart(count(10), now);
  until(b, false);
  EXPECT_TRUE(fromB.empty());
  const Seconds low = now;
  while (fromB.empty() && now < Seconds{1}) step();
  EXPECT_NEAR((now - low).value(), 0.005 + kByte, 2 * kStep);
  until(b, true);
  EXPECT_EQ(fromB.size(), 10U);
}

TEST_F(E32Test, isHalfDuplex) {
  a.fromUart(count(58), now);
  run(0.015);
  b.fromUart(count(58), now);
  run(0.3);
  EXPECT_TRUE(fromA.empty());
  EXPECT_TRUE(fromB.empty());
}

TEST_F(E32Test, hearsNobodyOfAnotherChannelAirRateOrAddress) {
  for (const E32Registers& other : {E32Registers::of(22, 5, 115200), E32Registers::of(23, 4, 115200),
                                    E32Registers{{0x12, 0x34, fast.bytes[2], 23, 0x44}}}) {
    E32 stranger{air, other};
    stranger.fromUart(count(10), now);
    for (int i = 0; i < 3000; ++i) {
      step();
      stranger.advance(now);
    }
    EXPECT_EQ(stranger.counters().sent, 1U);
    EXPECT_TRUE(fromA.empty());
  }
}

TEST_F(E32Test, takesAndTellsItsParametersInConfigurationMode) {
  change(a, RadioMode::Configure);
  a.fromUart(Bytes{0xC0, 0x00, 0x00, 0x3C, 0x07, 0x44}, now);
  run(0.05);
  EXPECT_EQ(fromA, (Bytes{0xC0, 0x00, 0x00, 0x3C, 0x07, 0x44}));
  fromA.clear();
  a.fromUart(Bytes{0xC1, 0xC1, 0xC1}, now);
  const Seconds asked = now;
  while (fromA.empty() && now < Seconds{1}) step();
  EXPECT_NEAR((now - asked).value(), 4 * 10.0 / 9600 + 0.005, 2 * kStep);  // always 9600 here
  run(0.05);
  EXPECT_EQ(fromA, (Bytes{0xC0, 0x00, 0x00, 0x3C, 0x07, 0x44}));
  change(a, RadioMode::Normal);
  EXPECT_EQ(a.registers().tuning(), (Tuning{7, 4}));
  EXPECT_EQ(a.registers().baud(), 115200);
}

TEST_F(E32Test, keepsSavedParametersOnlyWithoutPower) {
  change(a, RadioMode::Configure);
  a.fromUart(Bytes{0xC0, 0x00, 0x00, 0x3C, 0x07, 0x44}, now);
  run(0.05);
  a.fromUart(Bytes{0xC2, 0x00, 0x00, 0x3A, 0x09, 0x44}, now);
  run(0.05);
  EXPECT_EQ(a.registers().tuning(), (Tuning{9, 2}));
  a.setPowered(false, now);
  EXPECT_FALSE(a.ready());
  run(0.01);
  a.setPowered(true, now);
  EXPECT_EQ(a.registers().tuning(), (Tuning{7, 4}));
}

TEST_F(E32Test, tellsItsVersion) {
  change(a, RadioMode::Configure);
  a.fromUart(Bytes{0x11, 0xC3, 0xC3, 0xC3}, now);
  run(0.05);
  ASSERT_EQ(fromA.size(), 4U);
  EXPECT_EQ(fromA[0], 0xC3);
  EXPECT_EQ(fromA[1], 0x32);
}

TEST_F(E32Test, neverTakesFixedTransmission) {
  change(a, RadioMode::Configure);
  a.fromUart(Bytes{0xC0, 0x00, 0x00, 0x3D, 0x17, 0xC4}, now);
  run(0.05);
  EXPECT_EQ(fromA.back(), 0x44);
}

TEST_F(E32Test, finishesWhatItHasBeforeAChangeOfMode) {
  a.fromUart(count(20), now);
  a.setMode(RadioMode::Configure, now);
  a.fromUart(count(5), now);  // too late: dropped
  run(0.3);
  EXPECT_EQ(fromB, count(20));
  EXPECT_EQ(a.counters().deaf, 5U);
  EXPECT_EQ(a.mode(), RadioMode::Configure);
  EXPECT_TRUE(a.ready());
}

TEST_F(E32Test, needsAMillisecondForAChangeOfMode) {
  a.setMode(RadioMode::Configure, now);
  step();
  EXPECT_FALSE(a.ready());
  EXPECT_NEAR(until(a, true), 0.001, 2 * kStep);
}

TEST_F(E32Test, isDeafAndMuteOutsideNormalMode) {
  change(a, RadioMode::PowerSaving);
  a.fromUart(count(10), now);
  b.fromUart(count(10), now);
  run(0.2);
  EXPECT_TRUE(fromA.empty());
  EXPECT_TRUE(fromB.empty());
}

TEST_F(E32Test, losesThePacketOnTheAirWithItsPower) {
  a.fromUart(count(30), now);
  run(0.01);
  ASSERT_EQ(a.counters().sent, 1U);
  a.setPowered(false, now);
  run(0.3);
  EXPECT_TRUE(fromB.empty());
}

TEST_F(E32Test, isTheSameInAnyStepLength) {
  Air other{{1.0, 0.0, Seconds{}}, RandomStream{1, "air"}};
  E32 c{other, fast};
  E32 d{other, fast};
  a.fromUart(count(130), now);
  c.fromUart(count(130), now);
  Bytes fromD;
  for (int i = 1; i <= 60; ++i) {
    run(0.005);
    c.advance(now);
    for (const auto& x : other.settle(now)) d.receive(x.packet, x.at);
    for (const auto byte : d.takeUart(now)) fromD.push_back(byte);
    EXPECT_EQ(c.counters().sent, a.counters().sent);
  }
  EXPECT_EQ(fromD, fromB);
}

}  // namespace
}  // namespace tessera::sim
