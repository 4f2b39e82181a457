// What goes wrong, the sentence that says so, and that things go on when the cause is gone.
#include <gtest/gtest.h>

#include "supervisor/supervisor_fixture.h"

namespace tessera::supervisor {
namespace {

using test::SupervisorRig;

class Adversity : public ::testing::Test {
protected:
  void SetUp() override {
    rig.runRoute(1, "paper", 0.2);
    ASSERT_TRUE(rig.runUntil([&] { return moving(); }, Seconds{10}));
  }
  [[nodiscard]] bool moving() { return rig.vehicle(1).speed > 0.15; }
  [[nodiscard]] bool standing() { return rig.vehicle(1).speed == 0.0; }
  void expectEpisode(EventKind kind, const std::string& sentence) {
    const auto begun = rig.told(kind);
    ASSERT_EQ(begun.size(), 1U);
    EXPECT_EQ(begun[0].sentence.english().substr(0, sentence.size()), sentence);
    EXPECT_EQ(rig.told(kind, true).size(), 1U) << "told once that it is over";
  }
  SupervisorRig rig;
};

TEST_F(Adversity, aLostPortStopsTheVehicleAndItGoesOnWhenThePortIsBack) {
  rig.unplug();
  const std::size_t wrote = rig.wrote.size();
  ASSERT_TRUE(rig.runUntil([&] { return standing(); }, Seconds{1.5}));
  rig.run(Seconds{5});
  EXPECT_EQ(rig.wrote.size(), wrote) << "nothing is written to a lost port";
  EXPECT_EQ(rig.last->port.state, PortState::Lost);
  EXPECT_EQ(rig.view(1).waits, "AGV 1 waits: the port /dev/radio is lost.");
  rig.plug();
  EXPECT_TRUE(rig.runUntil([&] { return moving(); }, Seconds{5}));
  expectEpisode(EventKind::PortLost, "The port /dev/radio is lost: the other end is gone.");
  EXPECT_TRUE(rig.told(EventKind::Silent).empty()) << "the port explains it";
}

TEST_F(Adversity, silenceIsToldOnceAndTheRouteGoesOn) {
  rig.vehicle(1).fake.on = false;
  ASSERT_TRUE(rig.runUntil([&] { return standing(); }, Seconds{2}));
  rig.run(Seconds{8});
  EXPECT_EQ(rig.view(1).contact, Contact::Silent);
  EXPECT_NE(rig.view(1).waits.english().find("AGV 1 waits: it has not answered for "), std::string::npos);
  rig.vehicle(1).fake.on = true;
  EXPECT_TRUE(rig.runUntil([&] { return moving(); }, Seconds{6}));
  expectEpisode(EventKind::Silent, "AGV 1 has not answered for 1.");
}

TEST_F(Adversity, aRestartedVehicleIsTakenUpAgain) {
  rig.vehicle(1).restart();
  EXPECT_TRUE(rig.runUntil([&] { return moving() && !rig.told(EventKind::Restarted, true).empty(); }, Seconds{5}));
  expectEpisode(EventKind::Restarted, "AGV 1 has restarted (its power was switched on)");
  ASSERT_TRUE(rig.runUntil([&] { return rig.view(1).finished; }, Seconds{120})) << rig.view(1).doing;
}

TEST_F(Adversity, aVehiclePutElsewhereIsToldAsLostUntilItsPlaceIsKnownAgain) {
  ASSERT_TRUE(rig.runUntil([&] { return !rig.told(EventKind::Located).empty(); }, Seconds{10}));
  // Again and again: the locator follows a single jump without getting lost.
  for (int i = 0; i < 20 && rig.told(EventKind::Lost).empty(); ++i) {
    rig.vehicle(1).pose.position = rig.vehicle(1).pose.position + Offset{Metres{i % 2 == 0 ? 0.6 : -0.5}, Metres{0.1}};
    rig.run(Seconds{1});
  }
  ASSERT_TRUE(rig.runUntil([&] { return !rig.told(EventKind::Lost, true).empty(); }, Seconds{60})) << rig.view(1).doing;
  expectEpisode(EventKind::Lost, "AGV 1 has lost its place and stands.");
  ASSERT_FALSE(rig.told(EventKind::Doubted).empty());
  EXPECT_EQ(rig.told(EventKind::Doubted).front().sentence.english(),
            "AGV 1 read a tag that lies elsewhere: it goes on slowly until others tell where it is.");
  EXPECT_EQ(rig.told(EventKind::Located).size(), 1U) << "the first time only";
}

TEST_F(Adversity, whatIsFartherThanARangerTellsIsNoObstacle) {
  rig.vehicle(1).range = 253;
  ASSERT_TRUE(rig.runUntil([&] { return rig.view(1).obstacle.has_value(); }, Seconds{2}));
  EXPECT_EQ(rig.view(1).obstacle, Metres{2.53});
  rig.vehicle(1).range = 254;  // so far or farther
  EXPECT_TRUE(rig.runUntil([&] { return !rig.view(1).obstacle.has_value(); }, Seconds{2}));
}

TEST_F(Adversity, anObstacleIsToldWithItsDistance) {
  rig.vehicle(1).blocked = true;
  ASSERT_TRUE(rig.runUntil([&] { return rig.view(1).state == wire::VehicleState::Obstacle; }, Seconds{2}));
  EXPECT_EQ(rig.view(1).waits, "AGV 1 waits: an obstacle stands 23 cm before it.");
  rig.run(Seconds{5});
  rig.vehicle(1).blocked = false;
  EXPECT_TRUE(rig.runUntil([&] { return moving(); }, Seconds{3}));
  rig.run(Seconds{1});
  expectEpisode(EventKind::Obstacle, "AGV 1 stands before an obstacle, 23 cm away.");
}

TEST_F(Adversity, aDeadRangerIsToldAsThatAndNotAsAnObstacle) {
  rig.vehicle(1).blocked = true;
  rig.vehicle(1).fake.report.faults = wire::kFaultRanger;
  ASSERT_TRUE(rig.runUntil([&] { return rig.view(1).state == wire::VehicleState::Obstacle; }, Seconds{2}));
  EXPECT_EQ(rig.view(1).waits, "AGV 1 waits: one of its rangers does not answer.");
  rig.run(Seconds{2});
  rig.vehicle(1).fake.report.faults = 0;
  rig.vehicle(1).blocked = false;
  EXPECT_TRUE(rig.runUntil([&] { return moving(); }, Seconds{3}));
  rig.run(Seconds{2});
  expectEpisode(EventKind::Fault, "AGV 1 gets no answer from one of its rangers and does not drive forwards.");
  EXPECT_TRUE(rig.told(EventKind::Obstacle).empty());
  EXPECT_TRUE(rig.told(EventKind::Obstacle, true).empty());
}

TEST_F(Adversity, anObstacleThatWasThereBeforeARangerDiedIsNotGoneByThat) {
  rig.vehicle(1).blocked = true;
  ASSERT_TRUE(rig.runUntil([&] { return !rig.told(EventKind::Obstacle).empty(); }, Seconds{2}));
  rig.vehicle(1).fake.report.faults = wire::kFaultRanger;
  ASSERT_TRUE(rig.runUntil([&] { return !rig.told(EventKind::Fault).empty(); }, Seconds{2}));
  rig.run(Seconds{2});
  EXPECT_TRUE(rig.told(EventKind::Obstacle, true).empty());
  rig.vehicle(1).fake.report.faults = 0;
  rig.vehicle(1).blocked = false;
  EXPECT_TRUE(rig.runUntil([&] { return moving(); }, Seconds{3}));
  expectEpisode(EventKind::Obstacle, "AGV 1 stands before an obstacle");
}

TEST_F(Adversity, replayedFramesAreDroppedAndToldOnce) {
  for (int i = 0; i < 20; ++i)
    rig.air->inject(rig.air->vehicleFrames.back().second, rig.air->now + Seconds{0.1 * i + 0.003});
  rig.run(Seconds{10});
  EXPECT_EQ(rig.view(1).link.replayed, 20U);
  expectEpisode(EventKind::ReplayedFrames, "A frame of AGV 1 came a second time and was dropped");
  EXPECT_TRUE(rig.told(EventKind::Silent).empty());
}

TEST_F(Adversity, changedBytesAreDroppedAndToldOnce) {
  int count = 0;
  rig.air->tamper = [&](test::FakeAir::Bytes b) {
    if (++count % 5 == 0) b[b.size() / 2] ^= 0x10U;
    return b;
  };
  rig.run(Seconds{5});
  rig.air->tamper = {};
  rig.run(Seconds{10});
  expectEpisode(EventKind::DamagedFrames, "Damaged bytes come from the radio");
  EXPECT_TRUE(rig.told(EventKind::Silent).empty());
}

TEST_F(Adversity, garbageMakesNoStormOfEvents) {
  const std::size_t before = rig.events.size();
  std::mt19937 random{5};
  for (int i = 0; i < 300; ++i) {
    std::vector<std::uint8_t> noise(1 + random() % 60);
    for (auto& b : noise) b = static_cast<std::uint8_t>(random());
    rig.air->inject(noise, rig.air->now + Seconds{0.01 * i});
  }
  rig.run(Seconds{12});
  EXPECT_LT(rig.events.size() - before, 8U);
}

TEST_F(Adversity, noiseCountsUntilAVehicleIsHeard) {
  rig.vehicle(1).fake.on = false;
  rig.run(Seconds{3});
  rig.air->inject(std::vector<std::uint8_t>(100, 0x11), rig.air->now);
  rig.run(Seconds{1});
  EXPECT_GE(rig.last->channel.noiseSinceHeard, 90U);
  rig.vehicle(1).fake.on = true;
  rig.run(Seconds{6});
  ASSERT_EQ(rig.view(1).contact, Contact::Connected);
  EXPECT_EQ(rig.last->channel.noiseSinceHeard, 0U);
  EXPECT_GE(rig.last->channel.skippedBytes, 90U) << "the whole is still known";
}

TEST_F(Adversity, aRefusedCommandIsToldByTheVehicleOnce) {
  rig.vehicle(1).fake.report.faults = wire::kFaultReplayed;
  rig.run(Seconds{2});
  rig.vehicle(1).fake.report.faults = 0;
  rig.run(Seconds{7});
  expectEpisode(EventKind::ReplayedFrames, "AGV 1 refused a command that it had seen before");
}

TEST_F(Adversity, aFaultedVehicleGoesOnAfterClear) {
  auto& vehicle = rig.vehicle(1);
  vehicle.fake.report.faults = wire::kFaultMotorStall;
  rig.run(Seconds{2});
  bool cleared = false;
  const auto obey = vehicle.fake.onCommand;
  vehicle.fake.onCommand = [&, obey](const wire::CycleEntry& e, Seconds at) {
    if (e.mode == wire::CommandMode::Clear) cleared = true;
    obey(e, at);
  };
  rig.supervisor.post(Clear{VehicleId{1}});
  ASSERT_TRUE(rig.runUntil([&] { return cleared; }, Seconds{2}));
  vehicle.fake.report.faults = 0;
  EXPECT_TRUE(rig.runUntil([&] { return moving(); }, Seconds{3}));
}

TEST(WrongKey, isToldOnceAndTheVehicleIsNotCommanded) {
  SupervisorRig rig;
  const wire::Key good = rig.vehicle(1).fake.key;
  rig.vehicle(1).fake.key[3] ^= 0xFFU;
  rig.runRoute(1, "paper", 0.1);
  rig.run(Seconds{20});
  ASSERT_EQ(rig.told(EventKind::WrongKey).size(), 1U);
  EXPECT_EQ(rig.view(1).contact, Contact::Refused);
  EXPECT_TRUE(rig.vehicle(1).fake.commands.empty());
  rig.vehicle(1).fake.key = good;
  EXPECT_TRUE(rig.runUntil([&] { return rig.vehicle(1).speed > 0.05; }, Seconds{6}));
}

TEST(WrongVersion, isToldOnce) {
  SupervisorRig rig;
  rig.vehicle(1).fake.protocol = 9;
  rig.run(Seconds{20});
  ASSERT_EQ(rig.told(EventKind::WrongVersion).size(), 1U);
  EXPECT_EQ(rig.told(EventKind::WrongVersion)[0].sentence.english().substr(0, 25), "AGV 1 speaks version 9 of");
}

}  // namespace
}  // namespace tessera::supervisor
