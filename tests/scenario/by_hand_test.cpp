// A vehicle with its true firmware driven by hand over a lossy radio, and what a commissioning does after that.
#include <gmock/gmock.h>

#include "scenario/scenario.h"

namespace tessera::scenario {
namespace {

using supervisor::EventKind;
using supervisor::Jog;
using supervisor::Task;

class ByHand : public ::testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(scenario.until(Seconds{30}, [&] { return scenario.recorder().allConnected(); }))
        << scenario.sentences();
    scenario.go(Seconds{1});
  }
  /// As a window does while keys are held.
  void hold(double speed, double turnRate, double seconds) {
    for (double t = 0; t < seconds; t += 0.1) {
      scenario.supervisor().post(Jog{VehicleId{1}, MetresPerSecond{speed}, RadiansPerSecond{turnRate}});
      scenario.go(Seconds{0.1});
    }
  }
  [[nodiscard]] sim::TrueState truth() { return *scenario.world().truth(VehicleId{1}); }
  [[nodiscard]] bool stands() { return abs(truth().speed) < MetresPerSecond{0.002}; }

  Scenario scenario{ScenarioSetup{}};
};

TEST_F(ByHand, drivesStraightAndStopsSoonAfterTheKeyIsLetGo) {
  const Pose before = truth().pose;
  hold(0.12, 0.0, 4.0);
  const Pose after = truth().pose;
  EXPECT_GT(distance(before.position, after.position).value(), 0.3);
  EXPECT_LT(std::abs(turnBetween(before.heading, after.heading).value()), 0.06);
  // 300 ms of the last Jog, the way of the Stop through the air, the braking; the radio may lose it once.
  ASSERT_TRUE(scenario.until(supervisor::kJogHolds + Seconds{1.2}, [&] { return stands(); }));
  EXPECT_LT(distance(after.position, truth().pose.position).value(), 0.12);
  ASSERT_TRUE(scenario.until(Seconds{5}, [&] { return scenario.view().task == Task::Stopped; }));
}

TEST_F(ByHand, turnsOnTheSpotBothWaysAndDrivesBackwardsAndInCurves) {
  Pose before = truth().pose;
  hold(0.0, 0.5, 3.0);
  EXPECT_NEAR(turnBetween(before.heading, truth().pose.heading).value(), 1.3, 0.5);
  EXPECT_LT(distance(before.position, truth().pose.position).value(), 0.03);
  scenario.go(Seconds{2});
  before = truth().pose;
  hold(0.0, -0.5, 3.0);
  EXPECT_NEAR(turnBetween(before.heading, truth().pose.heading).value(), -1.3, 0.5);
  hold(-0.1, 0.0, 2.0);
  EXPECT_LT(truth().speed.value(), -0.07);
  hold(0.1, 0.3, 3.0);
  EXPECT_GT(truth().speed.value(), 0.06) << "on in a curve, not standing to turn first";
}

TEST_F(ByHand, itsCompassCanBeCalibratedAfterwardsThoughAStopHeldIt) {
  using wire::Action;
  const auto calibrate = [&] {
    scenario.supervisor().post(
        supervisor::Ask{VehicleId{1}, {wire::MessageType::Do, static_cast<std::uint8_t>(Action::CalibrateCompass), 0}});
  };
  const auto state = [&] { return scenario.view().state; };
  hold(0.1, 0.0, 1.0);
  calibrate();
  scenario.go(Seconds{0.1});
  EXPECT_THAT(scenario.sentences(), testing::HasSubstr("it cannot do that while it drives. Stop it first."));
  ASSERT_TRUE(scenario.until(Seconds{5}, [&] { return scenario.view().task == Task::Stopped && stands(); }));
  scenario.go(Seconds{1});
  calibrate();
  ASSERT_TRUE(scenario.until(Seconds{5}, [&] { return state() == wire::VehicleState::Calibrating; }))
      << scenario.sentences();
  scenario.go(Seconds{5});
  EXPECT_EQ(state(), wire::VehicleState::Calibrating) << "no repeated Stop ends it";
  scenario.supervisor().post(supervisor::StopAll{});
  EXPECT_TRUE(scenario.until(Seconds{3}, [&] { return state() == wire::VehicleState::Standing && stands(); }))
      << "but a new one does";
}

TEST_F(ByHand, anObstacleStopsIt) {
  const Pose pose = truth().pose;
  scenario.world().addObstacle({placeOf(pose, {Metres{0.8}, Metres{0}}), Metres{0.1}});
  hold(0.15, 0.0, 8.0);
  EXPECT_TRUE(stands());
  EXPECT_THAT(scenario.view().waits.english(), testing::StartsWith("AGV 1 waits: an obstacle stands "));
  hold(-0.1, 0.0, 2.0);
  EXPECT_LT(truth().speed.value(), -0.05) << "back out of it";
}

}  // namespace
}  // namespace tessera::scenario
