// A link on which something takes time beside the airtime: a network between host and module, a slow module.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "link/channel_fixture.h"

namespace tessera::link {
namespace {

using test::ChannelRig;
using test::FakeAir;
using test::FakeVehicle;

struct DelayCase {
  std::uint8_t vehicles;
  double airRate;
  double factor;
  double loss;
  double delay;  ///< s, each way
};

std::ostream& operator<<(std::ostream& out, const DelayCase& c) {
  return out << int{c.vehicles} << " vehicles, " << c.airRate << " bit/s, factor " << c.factor << ", loss " << c.loss
             << ", delay " << c.delay << " s";
}

FakeAir::Options optionsOf(const DelayCase& c) {
  FakeAir::Options options;
  options.airRate = c.airRate;
  options.factor = c.factor;
  options.loss = c.loss;
  options.delayThere = options.delayBack = Seconds{c.delay};
  return options;
}

// Drives, reads tags all the time, so that reports have all lengths, until so many more reports have come.
bool reportsCome(ChannelRig& rig, std::size_t more) {
  std::mt19937 random{1};
  const std::size_t wanted = rig.count<Reported>() + more;
  std::uint8_t number = 0;
  Seconds next = rig.air->now;
  const Seconds limit{static_cast<double>(more) * 5.0};
  return rig.runUntil(
      [&] {
        if (rig.air->now >= next) {
          for (auto k = random() % 3; k > 0; --k) rig.fake(1).read(0, {number++, 1, 2, 3}, rig.air->now);
          next = rig.air->now + Seconds{0.3};
        }
        return rig.count<Reported>() >= wanted;
      },
      limit);
}

// By how much a report was taken too late, in ms.
int tooLate(const Reported& r) {
  const auto made = static_cast<std::uint16_t>(std::llround(r.sampledAt.value() * 1000));
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(made - r.report.clock));
}

class ADelayedLink : public ::testing::TestWithParam<DelayCase> {
protected:
  void SetUp() override {
    ASSERT_TRUE(rig.runUntil([&] { return rig.connected(); }, Seconds{60}));
    for (std::uint8_t id = 1; id <= GetParam().vehicles; ++id) rig.drive(id);
    ASSERT_TRUE(reportsCome(rig, 60));
  }
  ChannelRig rig{GetParam().vehicles, optionsOf(GetParam())};
};

TEST_P(ADelayedLink, tellsWhenAReportWasMade) {
  const std::size_t before = rig.count<Reported>();
  ASSERT_TRUE(reportsCome(rig, 100));
  const auto reports = rig.all<Reported>();
  for (std::size_t i = before; i < reports.size(); ++i)
    EXPECT_LE(std::abs(tooLate(reports[i])), 5) << "ms, report " << i;
}

TEST_P(ADelayedLink, tellsWhenACommandTakesEffect) {
  std::vector<Seconds> arrived;
  rig.fake(1).onCommand = [&](const wire::CycleEntry&, Seconds at) { arrived.push_back(at); };
  const std::size_t before = rig.count<CommandSent>();
  ASSERT_TRUE(reportsCome(rig, 50));
  const auto sent = rig.all<CommandSent>();
  ASSERT_GT(arrived.size(), 5U);
  // Each that arrives is one of those that left; the first may have been under way already.
  for (std::size_t i = 1; i < arrived.size(); ++i) {
    const bool expected =
        std::any_of(sent.begin() + static_cast<std::ptrdiff_t>(before), sent.end(), [&](const auto& s) {
          return s.vehicle == VehicleId{1} && std::abs((s.effectiveAt - arrived[i]).value()) < 0.005;
        });
    EXPECT_TRUE(expected) << arrived[i].value();
  }
}

TEST_P(ADelayedLink, missesNothingButWhatIsLost) {
  const unsigned overlaps = rig.air->overlaps;
  const std::uint32_t missed = rig.peer(1).quality.missed;
  const std::size_t silences = rig.count<Silent>();
  ASSERT_TRUE(reportsCome(rig, 200));
  EXPECT_EQ(rig.air->overlaps, overlaps) << "sent into an answer";
  if (GetParam().loss == 0.0) {
    EXPECT_EQ(rig.count<Silent>(), silences);
    EXPECT_EQ(rig.peer(1).quality.missed, missed);
  }
  EXPECT_EQ(rig.peer(1).quality.tagEventsLost, 0U);
}

INSTANTIATE_TEST_SUITE_P(Delays, ADelayedLink,
                         ::testing::Values(DelayCase{1, 19200, 1.0, 0.0, 0.02}, DelayCase{1, 19200, 1.0, 0.0, 0.3},
                                           DelayCase{1, 19200, 1.8, 0.05, 0.5}, DelayCase{3, 19200, 1.8, 0.0, 0.3},
                                           DelayCase{4, 19200, 3.2, 0.05, 0.1}, DelayCase{1, 2400, 1.0, 0.0, 0.1},
                                           DelayCase{2, 2400, 1.8, 0.05, 0.3}));

TEST(DelayedLink, doesNotMakeTheSlotsLonger) {
  ChannelRig near{3, optionsOf({3, 19200, 1.8, 0.0, 0.0})};
  ChannelRig far{3, optionsOf({3, 19200, 1.8, 0.0, 0.3})};
  for (ChannelRig* rig : {&near, &far}) {
    ASSERT_TRUE(rig->runUntil([&] { return rig->connected(); }, Seconds{60}));
    ASSERT_TRUE(reportsCome(*rig, 100));
  }
  EXPECT_LE(far.channel->timing().slotUnits(), near.channel->timing().slotUnits() + 2);
}

TEST(DelayedLink, isWaitedForFromTheFirstFrameOnAsItsCallHasTold) {
  ChannelRig rig{1, optionsOf({1, 19200, 1.0, 0.0, 0.4})};
  ASSERT_TRUE(rig.runUntil([&] { return rig.count<Reported>() > 0; }, Seconds{20}));
  EXPECT_EQ(rig.peer(1).quality.missed, 0U);
}

TEST(DelayedLink, isFollowedWhenItsDelayComesAndGoes) {
  ChannelRig rig{1, optionsOf({1, 19200, 1.8, 0.0, 0.0})};
  ASSERT_TRUE(rig.runUntil([&] { return rig.connected(); }, Seconds{20}));
  rig.drive(1);
  for (const double delay : {0.0, 0.5, 0.05}) {
    rig.air->options().delayThere = rig.air->options().delayBack = Seconds{delay};
    ASSERT_TRUE(reportsCome(rig, 100)) << delay;
    const std::uint32_t missed = rig.peer(1).quality.missed;
    ASSERT_TRUE(reportsCome(rig, 20)) << delay;
    EXPECT_EQ(rig.peer(1).quality.missed, missed) << delay;
    EXPECT_LE(std::abs(tooLate(rig.all<Reported>().back())), 5) << delay;
    EXPECT_NEAR(rig.channel->timing().delay().value(), delay, 0.006) << delay;
  }
}

// Before the first answer nobody knows of the delay, and calls are repeated faster than answers can come.
class ALinkSlowerThanItsCalls : public ::testing::TestWithParam<double> {};

TEST_P(ALinkSlowerThanItsCalls, isGivenTheTimeToAnswerTheLastOne) {
  const Seconds roundTrip{2 * GetParam() + 0.3};
  ChannelRig rig{1, optionsOf({1, 19200, 1.8, 0.0, GetParam()})};
  ASSERT_TRUE(rig.runUntil([&] { return rig.connected(); }, 4.0 * roundTrip));
  rig.drive(1);
  ASSERT_TRUE(reportsCome(rig, 10));
  EXPECT_EQ(rig.count<Identified>(), 1U);
  EXPECT_EQ(rig.peer(1).quality.missed, 0U);
  EXPECT_EQ(rig.peer(1).quality.replayed, 0U);
  EXPECT_NEAR(rig.channel->timing().delay().value(), GetParam(), 0.01);
}

TEST_P(ALinkSlowerThanItsCalls, connectsWhateverIsLost) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    FakeAir::Options options = optionsOf({1, 19200, 1.8, 0.2, GetParam()});
    options.jitter = Seconds{0.05};
    options.seed = seed;
    ChannelRig rig{1, options};
    EXPECT_TRUE(rig.runUntil([&] { return rig.count<Reported>() > 0; }, Seconds{60})) << seed;
  }
}

TEST_P(ALinkSlowerThanItsCalls, isFoundAgainWhenTheVehicleStartsAnewAndTheDelayHasGrownMeanwhile) {
  ChannelRig rig{1, optionsOf({1, 19200, 1.8, 0.0, 0.0})};
  ASSERT_TRUE(rig.runUntil([&] { return rig.connected(); }, Seconds{20}));
  rig.drive(1);
  ASSERT_TRUE(reportsCome(rig, 50));
  rig.fake(1).on = false;
  rig.run(Seconds{10});
  rig.air->options().delayThere = rig.air->options().delayBack = Seconds{GetParam()};
  rig.fake(1).restart();
  rig.fake(1).on = true;
  EXPECT_TRUE(rig.runUntil([&] { return rig.count<Identified>() == 2; }, Seconds{30}));
  EXPECT_TRUE(reportsCome(rig, 10));
}

// What the vehicle answers to a probe before any session.
FakeAir::Bytes hailOf(FakeVehicle vehicle) {
  wire::CycleWriter writer{10, 1};
  writer.add({vehicle.address, wire::CommandMode::Poll, 0, 0, 0, 0}, vehicle.key);
  std::array<std::uint8_t, wire::kMaxFrame> probe{};
  const std::size_t size = writer.finish(probe);
  FakeAir::Bytes hail;
  wire::FrameDecoder decoder;
  decoder.feed(wire::Bytes{probe}.first(size),
               [&](const wire::Frame& f) { hail = vehicle.hear(f, Seconds{1})->bytes; });
  return hail;
}

// As the answers to earlier probes do, or a stranger who plays one of them back.
TEST_P(ALinkSlowerThanItsCalls, isWaitedForWhateverHailsComeMeanwhile) {
  ChannelRig rig{1, optionsOf({1, 19200, 1.8, 0.0, GetParam()})};
  const FakeAir::Bytes hail = hailOf(rig.fake(1));
  for (int i = 1; i < 100; ++i) rig.air->inject(hail, rig.air->now + i * Seconds{0.17});
  EXPECT_TRUE(rig.runUntil([&] { return rig.count<Identified>() > 0; }, Seconds{15}));
}

TEST_P(ALinkSlowerThanItsCalls, isWaitedForWhateverComesUnderAnotherKey) {
  ChannelRig rig{1, optionsOf({1, 19200, 1.8, 0.0, GetParam()})};
  const FakeAir::Bytes hail = hailOf({rig.fake(1).address, {9, 9, 9}});
  for (int i = 1; i < 100; ++i) rig.air->inject(hail, rig.air->now + i * Seconds{0.17});
  EXPECT_TRUE(rig.runUntil([&] { return rig.count<Identified>() > 0; }, Seconds{15}));
}

INSTANTIATE_TEST_SUITE_P(Delays, ALinkSlowerThanItsCalls, ::testing::Values(0.6, 0.8, 1.0, 1.5, 2.0));

TEST(DelayedLink, isNeitherOpenedNorTimedByARecordedAnswer) {
  ChannelRig rig{1, optionsOf({1, 19200, 1.8, 0.0, 0.6})};
  unsigned answers = 0;
  rig.air->tamper = [&](FakeAir::Bytes bytes) { return ++answers == 1 ? bytes : FakeAir::Bytes{}; };
  rig.run(Seconds{3});
  ASSERT_GT(answers, 1U);
  ASSERT_FALSE(rig.connected());
  const Seconds delay = rig.channel->timing().delay();
  ASSERT_GT(delay, Seconds{0.4});
  rig.air->inject(rig.air->vehicleFrames.front().second, rig.air->now + Seconds{0.1});
  rig.run(Seconds{3});
  EXPECT_FALSE(rig.connected());
  EXPECT_EQ(rig.channel->timing().delay(), delay);
}

// Nothing on the wire tells more; a host that knew better would have to be told.
TEST(DelayedLink, isSplitInHalvesWhateverItsTrueHalvesAre) {
  FakeAir::Options options = optionsOf({1, 19200, 1.0, 0.0, 0.0});
  options.delayThere = Seconds{0.1};
  options.delayBack = Seconds{0.3};
  ChannelRig rig{1, options};
  ASSERT_TRUE(rig.runUntil([&] { return rig.connected(); }, Seconds{20}));
  rig.drive(1);
  ASSERT_TRUE(reportsCome(rig, 100));
  EXPECT_NEAR(rig.channel->timing().delay().value(), 0.2, 0.005);
  EXPECT_NEAR(tooLate(rig.all<Reported>().back()), 100, 5);
}

}  // namespace
}  // namespace tessera::link
