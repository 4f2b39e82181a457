#include "sim/air.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tessera::sim {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Channel {
  explicit Channel(AirSettings settings = {1.0, 0.0, Seconds{}}, std::uint64_t seed = 1)
      : air{settings, RandomStream{seed, "air"}} {
    for (auto& m : modules) {
      m = air.join();
      air.tune(m, Tuning{}, Seconds{});
    }
  }
  Seconds send(std::size_t module, double at, const Bytes& bytes = Bytes(20, 7)) {
    return air.transmit(modules.at(module), Tuning{}, 0, bytes, Seconds{at});
  }
  Air air;
  std::array<std::size_t, 3> modules{};
};

TEST(TimeOnAir, reproducesTheDataSheetOfTheModule) {
  const auto ms = [](int rate, std::size_t bytes) { return 1000 * timeOnAir(rate, bytes).value(); };
  EXPECT_NEAR(ms(5, 12), 10, 1);
  EXPECT_NEAR(ms(5, 58), 28, 1);
  EXPECT_NEAR(ms(4, 12), 21, 1);
  EXPECT_NEAR(ms(4, 58), 49, 1);
  EXPECT_NEAR(ms(2, 12), 144, 1);
  EXPECT_NEAR(ms(2, 58), 308, 1);
}

TEST(TimeOnAir, neverGetsShorterWithMoreBytesOrASlowerRate) {
  for (int rate = 0; rate < kAirRates; ++rate)
    for (std::size_t n = 0; n < 58; ++n) {
      EXPECT_LE(timeOnAir(rate, n).value(), timeOnAir(rate, n + 1).value());
      if (rate > 0) {
        EXPECT_LT(timeOnAir(rate, n).value(), timeOnAir(rate - 1, n).value());
      }
    }
}

TEST(AirRate, isFoundByItsNominalBitRate) {
  EXPECT_EQ(airRateOf(300), 0);
  EXPECT_EQ(airRateOf(19200), 5);
  EXPECT_EQ(airRateOf(9601), std::nullopt);
}

TEST(Air, deliversToEveryOtherListenerAfterTheTimeOnAirAndTheDelay) {
  Channel c{{2.0, 0.0, Seconds{0.1}}};
  const Seconds end = c.send(0, 1.0);
  EXPECT_NEAR((end - Seconds{1.0}).value(), 2 * timeOnAir(5, 20).value(), 1e-9);
  EXPECT_TRUE(c.air.settle(end + Seconds{0.099}).empty());
  const auto got = c.air.settle(end + Seconds{0.101});
  ASSERT_EQ(got.size(), 2U);
  EXPECT_EQ(got[0].module, c.modules[1]);
  EXPECT_EQ(got[1].module, c.modules[2]);
  EXPECT_DOUBLE_EQ(got[0].at.value(), end.value() + 0.1);
  EXPECT_EQ(got[0].packet.bytes, Bytes(20, 7));
}

TEST(Air, destroysPacketsThatOverlapForEveryReceiver) {
  Channel c;
  const Seconds end = c.send(0, 1.0);
  c.send(1, end.value() - 0.001);
  EXPECT_TRUE(c.air.settle(Seconds{2}).empty());
  EXPECT_EQ(c.air.counters().collided, 1U);
}

TEST(Air, letsPacketsPassThatFollowEachOther) {
  Channel c;
  const Seconds end = c.send(0, 1.0);
  c.send(1, end.value());
  EXPECT_EQ(c.air.settle(Seconds{2}).size(), 4U);
}

TEST(Air, isHalfDuplex) {
  Channel c;
  c.send(0, 1.0);
  c.send(1, 1.005);
  for (const auto& d : c.air.settle(Seconds{2})) EXPECT_NE(d.module, c.modules[1]);
}

TEST(Air, reachesOnlyModulesOfTheSameTuningThatListenThroughout) {
  Channel c;
  c.air.tune(c.modules[1], Tuning{24, 5}, Seconds{0.5});
  c.send(0, 1.0);
  auto got = c.air.settle(Seconds{2});
  ASSERT_EQ(got.size(), 1U);
  EXPECT_EQ(got[0].module, c.modules[2]);
  c.send(0, 3.0);
  c.air.tune(c.modules[2], std::nullopt, Seconds{3.001});
  c.air.tune(c.modules[2], Tuning{}, Seconds{3.002});
  EXPECT_TRUE(c.air.settle(Seconds{4}).empty());
}

TEST(Air, breaksOffThePacketOfAModuleWithoutPower) {
  Channel c;
  c.send(0, 1.0);
  c.air.breakOff(c.modules[0]);
  EXPECT_TRUE(c.air.settle(Seconds{2}).empty());
}

TEST(Air, losesTheShareOfPacketsThatItWasTold) {
  Channel c{{1.0, 0.1, Seconds{}}};
  const int packets = 5000;
  int got = 0;
  for (int i = 0; i < packets; ++i) {
    c.send(0, i);
    got += static_cast<int>(c.air.settle(Seconds{i + 0.9}).size());
  }
  // Two receivers each; four standard deviations of the binomial.
  EXPECT_NEAR(got, 2 * packets * 0.9, 4 * std::sqrt(2 * packets * 0.1 * 0.9));
  EXPECT_EQ(c.air.counters().delivered, static_cast<std::uint64_t>(got));
}

TEST(Air, repeatsItselfWithTheSameSeedOnly) {
  const auto run = [](std::uint64_t seed) {
    Channel c{{1.0, 0.3, Seconds{}}, seed};
    std::vector<std::size_t> who;
    for (int i = 0; i < 50; ++i) {
      c.send(0, i);
      for (const auto& d : c.air.settle(Seconds{i + 0.9})) who.push_back(100U * static_cast<unsigned>(i) + d.module);
    }
    return who;
  };
  EXPECT_EQ(run(3), run(3));
  EXPECT_NE(run(3), run(4));
}

TEST(Air, reportsTheDutyCycle) {
  Channel c;
  c.send(0, 0.0);
  EXPECT_NEAR(c.air.dutyCycle(c.modules[0], Seconds{1}), timeOnAir(5, 20).value(), 1e-12);
  EXPECT_EQ(c.air.dutyCycle(c.modules[1], Seconds{1}), 0.0);
}

TEST(Air, sendsAStrangersBytesWhenTheChannelIsFree) {
  Channel c;
  const Seconds end = c.send(0, 1.0);
  c.air.inject(Tuning{}, Bytes(70, 1));
  EXPECT_TRUE(c.air.settle(Seconds{1.001}).empty());
  std::vector<std::size_t> sizes;
  for (double t = end.value(); t < 2; t += 0.001)
    for (const auto& d : c.air.settle(Seconds{t}))
      if (d.module == c.modules[0]) sizes.push_back(d.packet.bytes.size());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{58, 12}));
}

TEST(ChannelTap, changesOneByteOfThePacketThatWasMeant) {
  Channel c;
  c.air.tap().corruptNext(
      1, [](std::span<const std::uint8_t> b) { return b[0] == 9; }, 2);
  c.send(0, 1.0);
  EXPECT_EQ(c.air.settle(Seconds{2}).at(0).packet.bytes, Bytes(20, 7));
  c.send(0, 3.0, Bytes(5, 9));
  const auto changed = c.air.settle(Seconds{4}).at(0).packet.bytes;
  EXPECT_NE(changed[2], 9);
  EXPECT_EQ(changed[1], 9);
  c.send(0, 5.0, Bytes(5, 9));
  EXPECT_EQ(c.air.settle(Seconds{6}).at(0).packet.bytes, Bytes(5, 9));
  EXPECT_EQ(c.air.tap().heard().size(), 3U);
}

TEST(ChannelTap, suppressesAndRepeatsAtTheRatesThatItWasTold) {
  Channel c;
  c.air.tap().disturb({0.0, 0.25, 0.5}, 7);
  std::size_t got = 0;
  for (int i = 0; i < 1000; ++i) {
    c.send(0, i);
    for (const double part : {0.1, 0.5, 0.9}) got += c.air.settle(Seconds{i + part}).size();
  }
  const auto& counters = c.air.tap().counters();
  EXPECT_NEAR(static_cast<double>(counters.dropped), 250, 60);
  EXPECT_NEAR(static_cast<double>(counters.replayed), 500, 70);
  EXPECT_EQ(got, 2 * (1000 - counters.dropped) + 3 * counters.replayed);
}

}  // namespace
}  // namespace tessera::sim
