#include "firmware/vehicle/vehicle.h"

#include <gtest/gtest.h>

#include "tests/firmware/vehicle_bench.h"

namespace tessera::firmware::test {
namespace {

using wire::MessageType;
using wire::Outcome;
using wire::Parameter;
using wire::VehicleState;

double fromDegrees(double degrees) { return degrees * M_PI / 180.0; }

TEST(Vehicle, introducesItselfWithinTwoTenthsOfASecond) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  EXPECT_EQ(bench.host.identity->boot, 1U);
  EXPECT_EQ(bench.host.identity->readers, 3);
  EXPECT_EQ(bench.host.identity->rangers, kRangers);
  EXPECT_EQ(bench.host.report->state, VehicleState::Standing);
  EXPECT_EQ(bench.host.report->faults, 0);
  EXPECT_EQ(bench.host.report->readers, 0b111);
  EXPECT_EQ(bench.host.report->battery, 120);
  EXPECT_EQ(bench.host.report->range, 255);
}

TEST(Vehicle, reachesSpeedAndBearingWithoutSwinging) {
  for (const double target : {30.0, 90.0, 175.0, -120.0}) {
    VehicleBench bench;
    ASSERT_TRUE(bench.open());
    double beyond = 0.0;
    const double side = target < 0 ? -1.0 : 1.0;
    bench.everyMs = [&] { beyond = std::max(beyond, side * (bench.plant.bearing - fromDegrees(target))); };
    bench.drive(200, fromDegrees(target), 6000);
    EXPECT_NEAR(bench.plant.bearing, fromDegrees(target), fromDegrees(1.0)) << target;
    EXPECT_LT(beyond, fromDegrees(5.0)) << target;
    EXPECT_NEAR(bench.plant.speed(), 0.2, 0.01) << target;
    EXPECT_EQ(bench.state(), VehicleState::Driving);
    EXPECT_NEAR(bench.host.report->speed, 200, 20);
    const double reported = bench.host.report->bearing / 65536.0 * 2 * M_PI;
    EXPECT_NEAR(std::remainder(reported - fromDegrees(target), 2 * M_PI), 0.0, fromDegrees(1.0));
  }
}

TEST(Vehicle, keepsStraightWithUnequalMotorsAtEverySpeed) {
  for (const auto speed : std::array<std::int16_t, 5>{50, 80, 120, 200, 400}) {
    VehicleBench bench;
    bench.plant.wheels[0].fullSpeed = 0.75;
    bench.plant.wheels[1].fullSpeed = 0.85;
    ASSERT_TRUE(bench.open());
    bench.drive(speed, 0.0, 3000);
    const double start = bench.plant.y;
    double worst = 0.0;
    bench.everyMs = [&] { worst = std::max(worst, std::fabs(bench.plant.bearing)); };
    bench.drive(speed, 0.0, 3000);
    EXPECT_NEAR((bench.plant.y - start) / 3.0, speed / 1000.0, 0.004) << speed;
    EXPECT_LT(worst, fromDegrees(2.0)) << speed;
  }
}

TEST(Vehicle, drivesBackwardsWithTheNoseOnTheBearing) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  bench.drive(-150, 0.0, 3000);
  EXPECT_LT(bench.plant.y, -0.3);
  EXPECT_NEAR(bench.plant.bearing, 0.0, fromDegrees(1.5));
  EXPECT_LT(bench.host.report->travel | 0xFFFF0000U, 0xFFFFFFFFU);
}

TEST(Vehicle, turnsOnTheSpotAndThenStands) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  bench.drive(0, fromDegrees(90), 500);
  EXPECT_EQ(bench.state(), VehicleState::Turning);
  bench.drive(0, fromDegrees(90), 3000);
  EXPECT_EQ(bench.state(), VehicleState::Standing);
  EXPECT_NEAR(bench.plant.bearing, fromDegrees(90), fromDegrees(2));
  EXPECT_LT(std::hypot(bench.plant.x, bench.plant.y), 0.01);
  EXPECT_TRUE(bench.plant.standing());
}

TEST(Vehicle, stopsByItselfWhenCommandsStopComing) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  bench.drive(300, 0.0, 3000);
  ASSERT_GT(bench.plant.speed(), 0.25);
  bench.run(400 + 100 + 400);  // the rest of the expiry, some lag, and braking at 1.5 m/s²
  EXPECT_TRUE(bench.plant.standing());
  EXPECT_EQ(bench.state(), VehicleState::Expired);
  const double y = bench.plant.y;
  bench.run(2000);
  EXPECT_NEAR(bench.plant.y, y, 0.005);
  EXPECT_EQ(bench.board.duty[0], 0);
  EXPECT_EQ(bench.board.duty[1], 0);
  bench.drive(300, 0.0, 2000);
  EXPECT_GT(bench.plant.speed(), 0.25);
}

TEST(Vehicle, stopsBeforeAnObstacleAndGoesOnWhenItIsGone) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  const double wall = 2.0;
  bool there = true;
  bench.everyMs = [&] {
    bench.board.echoes[0] = there ? static_cast<std::uint32_t>((wall - bench.plant.y - 0.15) * 5800) : 38'000;
  };
  bench.drive(400, 0.0, 8000);
  EXPECT_EQ(bench.state(), VehicleState::Obstacle);
  EXPECT_TRUE(bench.plant.standing());
  EXPECT_LT(bench.plant.y + 0.15, wall - 0.10);
  EXPECT_GT(bench.plant.y, 1.2);
  EXPECT_LT(bench.host.report->range, 31);
  there = false;
  bench.drive(400, 0.0, 3500);
  EXPECT_GT(bench.plant.y, wall);
  EXPECT_EQ(bench.state(), VehicleState::Driving);
}

TEST(Vehicle, drivesForwardsOnlyWhileAllItsRangersAnswer) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  bench.drive(300, 0.0, 2000);
  EXPECT_EQ(bench.state(), VehicleState::Driving);
  EXPECT_EQ(bench.host.report->faults, 0);
  bench.board.echoes[1] = 0;
  bench.drive(300, 0.0, 2000);
  EXPECT_EQ(bench.state(), VehicleState::Obstacle);
  EXPECT_EQ(bench.host.report->faults, wire::kFaultRanger);
  EXPECT_TRUE(bench.plant.standing());
  const double stoodAt = bench.plant.y;
  bench.drive(-200, 0.0, 1000);
  EXPECT_LT(bench.plant.y, stoodAt - 0.05) << "backwards it needs no ranger";
  bench.board.echoes[1] = 38'000;
  bench.drive(300, 0.0, 2500);
  EXPECT_EQ(bench.state(), VehicleState::Driving);
  EXPECT_EQ(bench.host.report->faults, 0);
}

TEST(Vehicle, backsAwayFromAnObstacle) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  bench.board.echoes = {1000, 1000};
  bench.drive(200, 0.0, 1500);
  EXPECT_EQ(bench.state(), VehicleState::Obstacle);
  bench.drive(-200, 0.0, 2000);
  EXPECT_LT(bench.plant.y, -0.2);
}

TEST(Vehicle, refusesReplayedAndForgedCommandsAndSaysSo) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  const auto drive = bench.host.drive(300, 0, 50);
  bench.say(drive);
  bench.say(bench.host.stop());
  bench.run(500);
  for (int i = 0; i < 20; ++i) {
    bench.send(drive);
    bench.run(50);
  }
  EXPECT_TRUE(bench.plant.standing());
  EXPECT_EQ(bench.state(), VehicleState::Standing);
  EXPECT_NE(bench.host.report->faults & (wire::kFaultReplayed | wire::kFaultForged), 0);
  bench.state();
  EXPECT_EQ(bench.host.report->faults, 0) << "reported once";
  TestHost stranger{VehicleBench::kAddress, wire::Key{}};
  bench.say(stranger.drive(300, 0, 50));
  bench.run(500);
  EXPECT_TRUE(bench.plant.standing());
  EXPECT_EQ(bench.state(), VehicleState::Standing);
  EXPECT_EQ(bench.host.report->faults, wire::kFaultForged);
  EXPECT_EQ(bench.ask(MessageType::Get, static_cast<std::uint8_t>(Parameter::FramesRefused)).value, 21);
}

TEST(Vehicle, reportsTagsUntilTheHostHasThem) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  bench.bus.nodes[1] = {7, {1, 2, 3, 4, 5, 6, 7}};
  bench.run(50);
  bench.say(bench.host.poll());
  ASSERT_EQ(bench.host.report->eventCount, 1);
  EXPECT_EQ(bench.host.report->events[0].reader, 1);
  EXPECT_LE(bench.host.report->events[0].age, 6);
  bench.host.nextEvent = static_cast<std::uint8_t>(bench.host.report->firstEvent + 1);
  bench.say(bench.host.poll());
  EXPECT_EQ(bench.host.report->eventCount, 0);
}

TEST(Vehicle, warnsOfALowBatteryAndAMissingReader) {
  VehicleBench bench;
  bench.bus.setMillivolts(10'000);
  bench.bus.nodes.erase(2);
  ASSERT_TRUE(bench.open());
  EXPECT_EQ(bench.host.report->faults, wire::kFaultBattery | wire::kFaultReader);
  EXPECT_EQ(bench.host.report->readers, 0b011);
  bench.drive(200, 0.0, 2000);
  EXPECT_GT(bench.plant.speed(), 0.15) << "neither stops it";
}

}  // namespace
}  // namespace tessera::firmware::test
