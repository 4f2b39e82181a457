// Driving by hand: as long as the keys are held, no faster than by hand, and never against a Stop.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "supervisor/hand_drive.h"
#include "supervisor/supervisor_fixture.h"

namespace tessera::supervisor {
namespace {

using test::SupervisorRig;

TEST(HandDrive, holdsTheHeadingOfTheMomentWhileNoTurnIsAskedFor) {
  HandDrive hand{drive::VehicleAbility{}};
  const auto jog = [&](double speed, double turn, double now) {
    return hand.take({VehicleId{1}, MetresPerSecond{speed}, RadiansPerSecond{turn}}, Seconds{now});
  };
  EXPECT_TRUE(jog(0.1, 0.0, 1.0));
  EXPECT_EQ(hand.command(Radians{1.0}, Seconds{0.1}), (drive::Command{MetresPerSecond{0.1}, Radians{1.0}}));
  EXPECT_TRUE(jog(0.1, 0.0, 1.1));
  EXPECT_EQ(hand.command(Radians{1.2}, Seconds{0.1}).heading, Radians{1.0}) << "does not drift with the nose";
  EXPECT_TRUE(jog(0.0, 0.5, 1.2));
  EXPECT_NEAR(hand.command(Radians{1.2}, Seconds{0.01}).heading.value(), 1.2 + 0.5 / 3.0, 0.01);
  EXPECT_TRUE(jog(0.0, -99.0, 1.3));
  EXPECT_NEAR(hand.command(Radians{1.2}, Seconds{1.0}).heading.value(), 1.2 - 1.5, 0.1) << "the vehicle's own maximum";
  EXPECT_TRUE(jog(0.1, 0.0, 2.0));
  EXPECT_EQ(hand.command(Radians{-3.0}, Seconds{0.1}).heading, Radians{-3.0});
}

TEST(HandDrive, takesNothingAfterABarUntilTheKeysWereLetGo) {
  HandDrive hand{drive::VehicleAbility{}};
  const Jog jog{VehicleId{1}, MetresPerSecond{0.1}, RadiansPerSecond{}};
  hand.bar(Seconds{0.5});
  EXPECT_TRUE(hand.take(jog, Seconds{1.0})) << "no key was held when it was barred";
  hand.bar(Seconds{1.1});
  EXPECT_FALSE(hand.holds(Seconds{1.1}));
  for (double now = 1.2; now < 3.0; now += 0.1) EXPECT_FALSE(hand.take(jog, Seconds{now}));
  EXPECT_TRUE(hand.take(jog, Seconds{3.3}));
  EXPECT_TRUE(hand.holds(Seconds{3.5}));
  EXPECT_FALSE(hand.holds(Seconds{3.3} + kJogHolds));
}

class ByHand : public ::testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(rig.runUntil([&] { return rig.last && rig.view(1).contact == Contact::Connected; }, Seconds{5}));
    rig.run(Seconds{0.5});
  }
  /// As a window does while a key is held.
  void hold(double speed, double turn, double seconds) {
    for (double t = 0; t < seconds; t += 0.1) {
      rig.supervisor.post(Jog{VehicleId{1}, MetresPerSecond{speed}, RadiansPerSecond{turn}});
      rig.run(Seconds{0.1});
      fastest = std::max(fastest, std::abs(rig.vehicle(1).speed));
    }
  }
  SupervisorRig rig;
  double fastest = 0;
};

TEST_F(ByHand, drivesWhileTheKeyIsHeldAndStopsWhenItIsLetGo) {
  const Pose before = rig.vehicle(1).pose;
  hold(9.0, 0.0, 3.0);
  EXPECT_EQ(rig.view(1).task, Task::Jogging);
  EXPECT_EQ(rig.view(1).doing, "Driven by hand.");
  EXPECT_NEAR(fastest, kJogFastest.value(), 0.005) << "no faster than by hand";
  EXPECT_GT(distance(before.position, rig.vehicle(1).pose.position).value(), 0.25);
  EXPECT_NEAR(turnBetween(before.heading, rig.vehicle(1).pose.heading).value(), 0.0, 0.05);
  EXPECT_FALSE(rig.supervisor.allStopped());
  ASSERT_TRUE(rig.runUntil([&] { return rig.vehicle(1).speed == 0.0; }, kJogHolds + Seconds{0.7}));
  rig.run(Seconds{4});
  EXPECT_EQ(rig.view(1).task, Task::Stopped);
  EXPECT_EQ(rig.view(1).command->mode, wire::CommandMode::Stop);
  EXPECT_TRUE(rig.supervisor.allStopped());
  ASSERT_EQ(rig.told(EventKind::DrivenByHand).size(), 1U);
  EXPECT_EQ(rig.told(EventKind::DrivenByHand)[0].sentence, "AGV 1 is driven by hand.");
  EXPECT_EQ(rig.told(EventKind::DrivenByHand, true).size(), 1U);
}

TEST_F(ByHand, turnsOnTheSpotAtAboutTheRateAskedFor) {
  rig.vehicle(1).pose.heading = Radians{0.0};
  rig.run(Seconds{0.5});
  const Pose before = rig.vehicle(1).pose;
  hold(0.0, 0.4, 3.0);
  EXPECT_NEAR(turnBetween(before.heading, rig.vehicle(1).pose.heading).value(), 1.2, 0.35);
  EXPECT_LT(distance(before.position, rig.vehicle(1).pose.position).value(), 0.01);
  hold(-0.1, 0.0, 2.0);
  EXPECT_LT(rig.vehicle(1).speed, -0.08) << "backwards";
}

TEST_F(ByHand, needsNoKnownPlace) {
  SupervisorRig lost;
  floor::Site site = lost.map->site();
  site.vehicles[0].start.reset();
  site.placements.clear();
  lost.supervisor = Supervisor::create(floor::SiteMap::build(std::move(site)).value(), {}).value();
  lost.supervisor.portOpened("/dev/radio", lost.air->now);
  ASSERT_TRUE(lost.runUntil([&] { return lost.last && lost.view(1).contact == Contact::Connected; }, Seconds{5}));
  for (int i = 0; i < 15; ++i) {
    lost.supervisor.post(Jog{VehicleId{1}, MetresPerSecond{0.1}, RadiansPerSecond{0.0}});
    lost.run(Seconds{0.1});
  }
  EXPECT_FALSE(lost.view(1).located);
  EXPECT_EQ(lost.view(1).waits, "");
  EXPECT_GT(lost.vehicle(1).speed, 0.08);
}

TEST_F(ByHand, aKeyThatIsStillHeldAfterStopAllMovesNothing) {
  hold(0.1, 0.0, 2.0);
  rig.supervisor.post(StopAll{});
  hold(0.1, 0.0, 1.0);
  EXPECT_EQ(rig.vehicle(1).speed, 0.0);
  EXPECT_EQ(rig.view(1).task, Task::Stopped);
  const auto refused = rig.told(EventKind::OrderRefused);
  ASSERT_EQ(refused.size(), 1U) << "told once, however often the key repeats";
  EXPECT_EQ(refused[0].sentence, "AGV 1: it was stopped. Let the keys go before you drive it by hand again.");
  rig.run(Seconds{0.5});
  hold(0.1, 0.0, 1.0);
  EXPECT_GT(rig.vehicle(1).speed, 0.08);
}

TEST_F(ByHand, isRefusedWhileARouteRunsAndEndsWhenOneStarts) {
  rig.runRoute(1, "paper", 0.2);
  rig.run(Seconds{1});
  hold(-0.1, 0.0, 1.0);
  EXPECT_EQ(rig.view(1).task, Task::Running);
  ASSERT_EQ(rig.told(EventKind::OrderRefused).size(), 1U);
  EXPECT_EQ(rig.told(EventKind::OrderRefused)[0].sentence,
            "AGV 1: it cannot be driven by hand while it is on the route paper. Stop it first.");
  rig.supervisor.post(Stop{VehicleId{1}});
  rig.run(Seconds{1});
  hold(0.05, 0.0, 1.0);
  EXPECT_EQ(rig.view(1).task, Task::Jogging);
  EXPECT_EQ(rig.view(1).route, "");
  rig.runRoute(1, "paper", 0.2);
  EXPECT_TRUE(rig.runUntil([&] { return rig.vehicle(1).speed > 0.15; }, Seconds{10}));
}

TEST_F(ByHand, refusesWhatIsNoNumberAndVehiclesThatAreNotInTouch) {
  hold(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.5);
  hold(0.1, std::numeric_limits<double>::infinity(), 0.5);
  EXPECT_EQ(rig.vehicle(1).speed, 0.0);
  rig.vehicle(1).fake.on = false;
  rig.run(Seconds{3});
  hold(0.1, 0.0, 1.0);
  const auto refused = rig.told(EventKind::OrderRefused);
  ASSERT_EQ(refused.size(), 2U);
  EXPECT_EQ(refused[1].sentence, "AGV 1: it cannot be driven by hand, as it is not in touch.");
  EXPECT_EQ(rig.view(1).task, Task::None);
}

TEST_F(ByHand, aSilentVehicleDoesNotGoOnUnderAKeyThatWasHeldAllTheTime) {
  hold(0.1, 0.0, 1.0);
  rig.vehicle(1).fake.on = false;
  hold(0.1, 0.0, 5.0);
  rig.vehicle(1).fake.on = true;
  hold(0.1, 0.0, 5.0);
  EXPECT_EQ(rig.view(1).contact, Contact::Connected);
  EXPECT_EQ(rig.vehicle(1).speed, 0.0);
}

}  // namespace
}  // namespace tessera::supervisor
