// What goes wrong on a shop floor: each time a sentence says what happened, the vehicle stands within its command's
// expiry, and the drive goes on when the cause is gone.
#include "scenario/scenario.h"
#include "wire/frame.h"

namespace tessera::scenario {
namespace {

using supervisor::EventKind;

// The longest time that a vehicle may roll on without a command: the largest expiry that the supervisor gives at this
// air rate, and the time to brake from 0.12 m/s.
constexpr Seconds kStandsWithin{1.5};
constexpr MetresPerSecond kStanding{0.005};

class Adversity : public testing::Test {
protected:
  Adversity() : scenario_{ScenarioSetup{}} {}

  void driveHalfAMetre() {
    scenario_.orderRoutes();
    ASSERT_TRUE(scenario_.until(Seconds{60}, [&] { return scenario_.view().progress > Metres{0.5}; }))
        << scenario_.sentences();
  }
  void expectStandstill() {
    EXPECT_TRUE(scenario_.until(kStandsWithin, [&] { return abs(scenario_.trueSpeed()) < kStanding; }))
        << "still rolling at " << scenario_.trueSpeed().value() << " m/s\n"
        << scenario_.sentences();
  }
  void expectSentence(EventKind kind, bool over = false) {
    EXPECT_TRUE(scenario_.until(Seconds{20}, [&] { return scenario_.eventCount(kind, over) > 0; }))
        << "no event " << supervisor::nameOf(kind) << " in\n"
        << scenario_.sentences();
  }
  void expectArrival() {
    EXPECT_TRUE(scenario_.until(Seconds{240}, [&] { return scenario_.finished(); })) << scenario_.sentences();
    EXPECT_LT(scenario_.outcomes().front().metrics.endError.value(), 0.05);
    EXPECT_EQ(scenario_.outcomes().front().metrics.reversals, 0);
  }
  [[nodiscard]] static bool isFromHost(std::span<const std::uint8_t> packet) {
    return packet.size() > 3 && packet[3] == wire::kHostAddress;
  }

  Scenario scenario_;
};

TEST_F(Adversity, aPulledPortStopsTheVehicleAndAReplacedOneLetsItGoOn) {
  driveHalfAMetre();
  scenario_.lockstep().pullPort();
  expectStandstill();
  expectSentence(EventKind::PortLost);
  EXPECT_EQ(scenario_.lockstep().snapshot()->port.state, supervisor::PortState::Lost);
  scenario_.lockstep().plugPort();
  expectSentence(EventKind::PortLost, true);
  expectArrival();
}

TEST_F(Adversity, aDeadVehicleIsCalledSilentAndGoesOnWhenItIsStartedAgain) {
  driveHalfAMetre();
  ASSERT_TRUE(scenario_.world().kill(VehicleId{1}));
  expectStandstill();
  expectSentence(EventKind::Silent);
  ASSERT_TRUE(scenario_.world().start(VehicleId{1}).has_value());
  expectSentence(EventKind::Silent, true);
  expectArrival();
}

TEST_F(Adversity, aVehicleThatRestartsIsRecognisedAndGetsANewSession) {
  driveHalfAMetre();
  ASSERT_TRUE(scenario_.world().kill(VehicleId{1}));
  ASSERT_TRUE(scenario_.world().start(VehicleId{1}).has_value());
  expectSentence(EventKind::Restarted);
  expectArrival();
}

TEST_F(Adversity, garbageOnTheAirIsToldAndDisturbsNothing) {
  driveHalfAMetre();
  for (int burst = 0; burst < 20; ++burst) {
    scenario_.world().noise(200);
    scenario_.go(Seconds{0.5});
  }
  expectSentence(EventKind::DamagedFrames);
  expectArrival();
}

TEST_F(Adversity, aChangedByteIsNoticedWhereverItStandsInTheFrame) {
  driveHalfAMetre();
  for (std::size_t byte = 0; byte < 40; ++byte) {
    scenario_.world().tap().corruptNext(
        1, [](auto packet) { return !isFromHost(packet); }, byte);
    scenario_.go(Seconds{0.4});
  }
  expectSentence(EventKind::DamagedFrames);
  EXPECT_EQ(scenario_.view().link.forged, 0U);  // the checksum already refuses it
  expectArrival();
}

TEST_F(Adversity, aChangedByteInACommandNeverMovesTheVehicle) {
  driveHalfAMetre();
  scenario_.world().tap().corruptNext(1000, isFromHost, 20);
  expectStandstill();
  scenario_.world().tap().corruptNext(0);
  expectArrival();
}

TEST_F(Adversity, anOldCommandIsRefusedByTheVehicleAndTold) {
  driveHalfAMetre();
  std::vector<std::uint8_t> old;
  for (const auto& packet : scenario_.world().tap().heard()) {
    if (isFromHost(packet) && packet[4] == 0x02) old = packet;
  }
  ASSERT_FALSE(old.empty());
  scenario_.supervisor().post(supervisor::Stop{VehicleId{1}});
  scenario_.go(Seconds{3});
  ASSERT_LT(abs(scenario_.trueSpeed()), kStanding);
  // Nobody else may be on the air at that moment, or both would be lost: try until the vehicle has told of one.
  for (int tries = 0; tries < 200 && scenario_.eventCount(EventKind::ReplayedFrames) == 0; ++tries) {
    scenario_.world().inject(old);
    scenario_.go(Seconds{0.137});
    EXPECT_LT(abs(scenario_.trueSpeed()), kStanding) << "an old command moved the vehicle";
  }
  EXPECT_GT(scenario_.eventCount(EventKind::ReplayedFrames), 0U) << scenario_.sentences();
}

TEST_F(Adversity, anOldReportIsRefusedByTheSupervisorAndTold) {
  driveHalfAMetre();
  std::vector<std::uint8_t> old;
  for (const auto& packet : scenario_.world().tap().heard()) {
    if (!isFromHost(packet) && packet[4] == 0x82) old = packet;
  }
  ASSERT_FALSE(old.empty());
  for (int tries = 0; tries < 200 && scenario_.eventCount(EventKind::ReplayedFrames) == 0; ++tries) {
    scenario_.world().inject(old);
    scenario_.go(Seconds{0.137});
  }
  EXPECT_GT(scenario_.eventCount(EventKind::ReplayedFrames), 0U) << scenario_.sentences();
  expectArrival();
}

TEST_F(Adversity, anObstacleStopsTheVehicleAndItGoesOnWhenTheWayIsFree) {
  driveHalfAMetre();
  scenario_.world().addObstacle({{Metres{0.30}, Metres{1.35}}, Metres{0.05}});
  expectSentence(EventKind::Obstacle);
  expectStandstill();
  EXPECT_NE(scenario_.view().waits, "") << "the operator is not told why it waits";
  scenario_.world().clearObstacles();
  expectSentence(EventKind::Obstacle, true);
  expectArrival();
}

TEST_F(Adversity, aVehicleCarriedAwayIsFoundAgain) {
  driveHalfAMetre();
  ASSERT_TRUE(scenario_.world().push(VehicleId{1}, {Metres{0.45}, Metres{-0.2}}, Radians{0}));
  EXPECT_TRUE(scenario_.until(Seconds{240}, [&] { return scenario_.finished(); })) << scenario_.sentences();
  EXPECT_LT(scenario_.outcomes().front().metrics.endError.value(), 0.05);
}

TEST_F(Adversity, stopAllStandsEveryVehicleAndNothingMovesWithoutANewOrder) {
  driveHalfAMetre();
  scenario_.supervisor().post(supervisor::StopAll{});
  expectStandstill();
  scenario_.go(Seconds{10});
  EXPECT_LT(abs(scenario_.trueSpeed()), kStanding);
  EXPECT_FALSE(scenario_.finished());
}

TEST(LostPackets, slowTheDriveDownButDoNotEndIt) {
  ScenarioSetup setup;
  setup.world.drop = 0.2;
  Scenario scenario{setup};
  scenario.orderRoutes();
  EXPECT_TRUE(scenario.until(Seconds{300}, [&] { return scenario.finished(); })) << scenario.sentences();
  EXPECT_EQ(scenario.outcomes().front().metrics.reversals, 0);
}

TEST(AWrongKey, isToldAndTheVehicleStaysWhereItIs) {
  ScenarioSetup setup;
  setup.wrongKey = true;
  Scenario scenario{setup};
  EXPECT_TRUE(scenario.until(Seconds{30}, [&] { return scenario.eventCount(EventKind::WrongKey) > 0; }))
      << scenario.sentences();
  scenario.supervisor().post(supervisor::RunRoute{VehicleId{1}, "paper", MetresPerSecond{0.12}});
  scenario.go(Seconds{10});
  EXPECT_LT(abs(scenario.trueSpeed()), kStanding);
}

}  // namespace
}  // namespace tessera::scenario
