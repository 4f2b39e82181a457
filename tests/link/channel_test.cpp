#include "link/channel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "link/channel_fixture.h"

namespace tessera::link {
namespace {

using test::ChannelRig;
using test::FakeAir;

TEST(Channel, meetsItsVehicles) {
  ChannelRig rig{3};
  EXPECT_TRUE(rig.runUntil([&] { return rig.connected(); }, Seconds{2}));
  EXPECT_EQ(rig.count<Identified>(), 3U);
}

TEST(Channel, saysNothingWhileThePortIsClosed) {
  ChannelRig rig{1};
  rig.channel->closed();
  rig.run(Seconds{2});
  EXPECT_TRUE(rig.air->hostFrames.empty());
  rig.channel->opened(rig.air->now);
  EXPECT_TRUE(rig.runUntil([&] { return rig.connected(); }, Seconds{1}));
}

TEST(Channel, carriesTheCommandToTheVehicleAndSeesItAcknowledged) {
  ChannelRig rig{1};
  rig.channel->wish(VehicleId{1}, {wire::CommandMode::Drive, MetresPerSecond{0.123}, 0x4000, Seconds{0.41}});
  ASSERT_TRUE(rig.runUntil([&] { return rig.count<CommandAcknowledged>() > 0; }, Seconds{2}));
  const wire::CycleEntry& entry = rig.fake(1).commands.at(0);
  EXPECT_EQ(entry.mode, wire::CommandMode::Drive);
  EXPECT_EQ(entry.speed, 123);
  EXPECT_EQ(entry.bearing, 0x4000);
  EXPECT_EQ(entry.expiry, 21) << "rounded up to units of 20 ms";
}

TEST(Channel, saysWhichCommandStayedWithoutAnAnswer) {
  ChannelRig rig{1};
  rig.drive(1);
  ASSERT_TRUE(rig.runUntil([&] { return rig.count<CommandAcknowledged>() > 3; }, Seconds{2}));
  EXPECT_EQ(rig.count<CommandUnanswered>(), 0U);
  rig.air->options().loss = 1.0;
  ASSERT_TRUE(rig.runUntil([&] { return rig.count<CommandUnanswered>() > 0; }, Seconds{2}));
  rig.air->options().loss = 0.0;
  const std::uint32_t lost = rig.all<CommandUnanswered>().front().counter;
  rig.run(Seconds{1});
  EXPECT_GT(rig.all<CommandAcknowledged>().back().counter, lost);
}

TEST(Channel, mapsTheInstantOfAReportToItsOwnClock) {
  ChannelRig rig{1};
  rig.drive(1);
  rig.run(Seconds{5});
  for (const Reported& r : rig.all<Reported>()) {
    if (r.receivedAt < Seconds{12}) continue;  // the factor is being learned
    const auto made = static_cast<std::uint16_t>(std::llround(r.sampledAt.value() * 1000));
    const auto error = static_cast<std::int16_t>(static_cast<std::uint16_t>(made - r.report.clock));
    EXPECT_LE(std::abs(error), 3) << "ms";
  }
  EXPECT_GT(rig.count<Reported>(), 40U);
}

TEST(Channel, expectsACommandToArriveWhenItDoes) {
  ChannelRig rig{1};
  std::vector<Seconds> arrived;
  rig.fake(1).onCommand = [&](const wire::CycleEntry&, Seconds at) { arrived.push_back(at); };
  rig.drive(1);
  rig.run(Seconds{5});
  const auto sent = rig.all<CommandSent>();
  ASSERT_LE(arrived.size(), sent.size());
  for (std::size_t i = 20; i < arrived.size(); ++i) EXPECT_NEAR(arrived[i].value(), sent[i].effectiveAt.value(), 0.003);
}

TEST(Channel, doesNotHurryWhileNobodyDrives) {
  ChannelRig rig{1};
  rig.run(Seconds{10});
  EXPECT_LT(rig.fake(1).commands.size(), 55U);
  const std::size_t before = rig.fake(1).commands.size();
  rig.drive(1);
  rig.run(Seconds{10});
  EXPECT_GT(rig.fake(1).commands.size() - before, 90U);
}

TEST(Channel, sendsAStopWithTheNextFrameAndUntilItIsAcknowledged) {
  ChannelRig rig{9};
  ASSERT_TRUE(rig.runUntil([&] { return rig.connected(); }, Seconds{5}));
  for (std::uint8_t id = 1; id <= 9; ++id) rig.drive(id);
  rig.run(Seconds{2});
  const std::size_t frames = rig.air->hostFrames.size();
  rig.channel->wish(VehicleId{7}, {wire::CommandMode::Stop, {}, 0, {}});
  ASSERT_TRUE(rig.runUntil([&] { return rig.fake(7).commands.back().mode == wire::CommandMode::Stop; }, Seconds{2}));
  EXPECT_EQ(rig.air->hostFrames.size(), frames + 1);
}

TEST(Channel, repeatsALostStopWithoutStarvingTheOthers) {
  ChannelRig rig{6};
  ASSERT_TRUE(rig.runUntil([&] { return rig.connected(); }, Seconds{5}));
  for (std::uint8_t id = 1; id <= 6; ++id) rig.drive(id);
  rig.run(Seconds{2});
  rig.fake(3).on = false;
  rig.channel->wish(VehicleId{3}, {wire::CommandMode::Stop, {}, 0, {}});
  std::map<int, std::size_t> before;
  for (std::uint8_t id = 1; id <= 6; ++id) before[id] = rig.fake(id).commands.size();
  rig.run(Seconds{0.9});
  for (const std::uint8_t id : std::array<std::uint8_t, 5>{1, 2, 4, 5, 6})
    EXPECT_GE(rig.fake(id).commands.size() - before[id], 1U) << int{id};
  rig.fake(3).on = true;
  ASSERT_TRUE(rig.runUntil([&] { return rig.fake(3).commands.back().mode == wire::CommandMode::Stop; }, Seconds{4}));
}

TEST(Channel, noticesSilenceOnceAndTheReturn) {
  ChannelRig rig{1};
  rig.drive(1);
  rig.run(Seconds{3});
  rig.fake(1).on = false;
  rig.run(Seconds{10});
  EXPECT_EQ(rig.count<Silent>(), 1U);
  rig.fake(1).on = true;
  EXPECT_TRUE(rig.runUntil([&] { return rig.connected(); }, Seconds{4}));
  const std::size_t before = rig.fake(1).commands.size();
  rig.run(Seconds{1});
  EXPECT_GT(rig.fake(1).commands.size(), before);
}

TEST(Channel, meetsARestartedVehicleAgainAtOnce) {
  ChannelRig rig{2};
  rig.drive(1);
  rig.drive(2);
  rig.run(Seconds{3});
  rig.fake(1).restart();
  ASSERT_TRUE(rig.runUntil([&] { return rig.count<Restarted>() == 1; }, Seconds{1}));
  ASSERT_TRUE(rig.runUntil([&] { return rig.connected(); }, Seconds{1}));
  EXPECT_EQ(rig.all<Identified>().back().restarted, true);
  EXPECT_EQ(rig.count<Silent>(), 0U);
}

TEST(Channel, findsAVehicleWithAnotherKeyThatIgnoresTheCall) {
  ChannelRig rig{2};
  rig.fake(2).key = test::keyOf(9);
  EXPECT_TRUE(rig.runUntil([&] { return rig.count<WrongKey>() > 0; }, Seconds{5}));
  rig.run(Seconds{5});
  EXPECT_TRUE(rig.peer(1).connected());
  rig.fake(2).key = test::keyOf(2);
  EXPECT_TRUE(rig.runUntil([&] { return rig.connected(); }, Seconds{5}));
}

TEST(Channel, dropsAndCountsForgedAndReplayedFrames) {
  ChannelRig rig{1};
  rig.drive(1);
  rig.run(Seconds{3});
  const auto old = rig.air->vehicleFrames.back().second;
  const std::size_t reports = rig.count<Reported>();
  rig.air->inject(old, rig.air->now + Seconds{0.001});
  rig.run(Seconds{0.002});
  EXPECT_EQ(rig.peer(1).quality.replayed, 1U);
  EXPECT_LE(rig.count<Reported>(), reports + 1);
  auto forged = old;
  forged[12] ^= 0x80U;
  const std::uint16_t crc = wire::crc16(wire::Bytes{forged}.subspan(1, forged.size() - 3));
  forged[forged.size() - 2] = static_cast<std::uint8_t>(crc);
  forged[forged.size() - 1] = static_cast<std::uint8_t>(crc >> 8);
  rig.air->inject(forged, rig.air->now + Seconds{0.001});
  rig.run(Seconds{0.002});
  EXPECT_EQ(rig.peer(1).quality.forged, 1U);
  rig.run(Seconds{1});
  EXPECT_TRUE(rig.connected());
}

TEST(Channel, goesOnWorkingUnderGarbage) {
  ChannelRig rig{1};
  rig.drive(1);
  rig.run(Seconds{2});
  std::mt19937 random{7};
  for (int i = 0; i < 200; ++i) {
    std::vector<std::uint8_t> noise(1 + random() % 40);
    for (auto& b : noise) b = static_cast<std::uint8_t>(random() % 4 == 0 ? wire::kSync : random());
    rig.air->inject(noise, rig.air->now + Seconds{0.03 * i});
  }
  const std::size_t before = rig.count<Reported>();
  rig.run(Seconds{6.1});
  EXPECT_GT(rig.count<Noise>(), 0U);
  EXPECT_GT(rig.count<Reported>(), before + 20);
  rig.run(Seconds{2});
  EXPECT_TRUE(rig.connected());
}

TEST(Channel, saysNothingOfTheHalfFrameThatALostPortLeaves) {
  ChannelRig rig{1};
  rig.run(Seconds{2});
  rig.air->inject({wire::kSync, 20, 0, 1}, rig.air->now + Seconds{0.001});
  rig.run(Seconds{0.002});
  rig.channel->closed();
  rig.run(Seconds{1});
  rig.channel->opened(rig.air->now);
  rig.run(Seconds{2});
  EXPECT_EQ(rig.count<Noise>(), 0U);
  EXPECT_TRUE(rig.connected());
}

// On a machine that had other things to do the rest of a frame waits in the port, and is old when it is read.
TEST(Channel, takesTheRestOfAFrameHoweverLateItIsRead) {
  ChannelRig rig{1};
  rig.drive(1);
  ASSERT_TRUE(rig.runUntil([&] { return rig.count<Reported>() > 3; }, Seconds{3}));
  const std::size_t before = rig.count<Reported>();
  bool split = false;
  rig.host.ingest = [&](wire::Bytes bytes, Seconds t) {
    rig.channel->ingest(bytes.first(5), t);
    rig.channel->ingest(bytes.subspan(5), t + Seconds{0.2});
    split = true;
  };
  ASSERT_TRUE(rig.runUntil([&] { return split; }, Seconds{1}));
  const auto out = rig.channel->poll(rig.air->now + Seconds{0.2});
  EXPECT_EQ(rig.count<Reported>() + static_cast<std::size_t>(std::count_if(
                                        out.events.begin(), out.events.end(),
                                        [](const auto& e) { return std::holds_alternative<Reported>(e); })),
            before + 1);
}

TEST(Channel, findsTheFrameBehindAFalseStart) {
  ChannelRig rig{1};
  rig.drive(1);
  rig.run(Seconds{2});
  const std::size_t before = rig.peer(1).quality.missed;
  rig.air->tamper = [](FakeAir::Bytes b) {
    b.insert(b.begin(), {wire::kSync, 49, 7, 7});  // announces more than follows
    return b;
  };
  rig.run(Seconds{3});
  EXPECT_EQ(rig.peer(1).quality.missed, before);
  EXPECT_EQ(rig.count<Silent>(), 0U);
}

TEST(Channel, answersRequestsBetweenTheCycles) {
  ChannelRig rig{2};
  ASSERT_TRUE(rig.runUntil([&] { return rig.connected(); }, Seconds{2}));
  rig.drive(1);
  rig.drive(2);
  EXPECT_TRUE(rig.channel->request(VehicleId{2}, {wire::MessageType::Set, 7, 250}));
  ASSERT_TRUE(rig.runUntil([&] { return rig.count<Answered>() == 1; }, Seconds{2}));
  const Answered answered = rig.all<Answered>().front();
  ASSERT_TRUE(answered.value.has_value());
  EXPECT_EQ(answered.value->value, 250);
}

TEST(Channel, saysSoWhenARequestStaysUnanswered) {
  ChannelRig rig{1};
  ASSERT_TRUE(rig.runUntil([&] { return rig.connected(); }, Seconds{2}));
  rig.fake(1).on = false;
  EXPECT_TRUE(rig.channel->request(VehicleId{1}, {wire::MessageType::Get, 7, 0}));
  ASSERT_TRUE(rig.runUntil([&] { return rig.count<Answered>() == 1; }, Seconds{5}));
  EXPECT_FALSE(rig.all<Answered>().front().value.has_value());
}

TEST(Channel, doesNotQueueRequestsWithoutEnd) {
  ChannelRig rig{1};
  int taken = 0;
  for (int i = 0; i < 100; ++i) taken += rig.channel->request(VehicleId{1}, {wire::MessageType::Get, 7, 0}) ? 1 : 0;
  EXPECT_EQ(taken, 32);
  EXPECT_FALSE(rig.channel->request(VehicleId{77}, {wire::MessageType::Get, 7, 0}));
}

TEST(Channel, countsTagEventsThatTheVehicleDroppedAndRestartsWithIt) {
  ChannelRig rig{1};
  rig.drive(1);
  rig.run(Seconds{1});
  for (std::uint8_t i = 0; i < 5; ++i) rig.fake(1).read(0, {i, 0, 0, 0}, rig.air->now);
  rig.run(Seconds{2});
  rig.fake(1).restart();
  for (std::uint8_t i = 0; i < 5; ++i) rig.fake(1).read(1, {i, 1, 0, 0}, rig.air->now);
  rig.run(Seconds{3});
  std::size_t reads = 0;
  for (const Reported& r : rig.all<Reported>()) reads += r.tags.size();
  EXPECT_EQ(reads, 10U);
  EXPECT_EQ(rig.peer(1).quality.tagEventsLost, 0U);
}

TEST(Channel, makesTheSameFramesFromTheSameInputs) {
  std::vector<std::pair<Seconds, std::vector<std::uint8_t>>> runs[2];
  for (auto& frames : runs) {
    FakeAir::Options options;
    options.loss = 0.1;
    options.jitter = Seconds{0.01};
    options.seed = 3;
    ChannelRig rig{3, options};
    for (std::uint8_t id = 1; id <= 3; ++id) rig.drive(id);
    rig.run(Seconds{10});
    frames = rig.air->hostFrames;
  }
  EXPECT_EQ(runs[0], runs[1]);
}

}  // namespace
}  // namespace tessera::link
