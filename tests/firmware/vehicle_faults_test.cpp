#include <gtest/gtest.h>

#include "firmware/vehicle/vehicle.h"
#include "tests/firmware/vehicle_bench.h"

namespace tessera::firmware::test {
namespace {

using wire::MessageType;
using wire::Outcome;
using wire::Parameter;
using wire::VehicleState;

TEST(Vehicle, latchesAStallUntilItIsCleared) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  bench.drive(200, 0.0, 1000);
  bench.plant.wheels[0].blocked = true;
  bench.drive(200, 0.0, 3000);
  EXPECT_EQ(bench.state(), VehicleState::Faulted);
  EXPECT_EQ(bench.host.report->faults & wire::kFaultMotorStall, wire::kFaultMotorStall);
  EXPECT_EQ(bench.board.duty[1], 0);
  bench.plant.wheels[0].blocked = false;
  bench.drive(200, 0.0, 500);
  EXPECT_EQ(bench.state(), VehicleState::Faulted);
  bench.say(bench.host.clear());
  EXPECT_EQ(bench.state(), VehicleState::Standing);
  bench.drive(200, 0.0, 4000);
  EXPECT_NEAR(bench.plant.speed(), 0.2, 0.02);
}

TEST(Vehicle, latchesAWatchdogStart) {
  VehicleBench bench;
  bench.board.cause = wire::ResetCause::Watchdog;
  bench.switchOn();
  ASSERT_TRUE(bench.open());
  EXPECT_EQ(bench.host.report->state, VehicleState::Faulted);
  EXPECT_EQ(bench.host.report->faults, wire::kFaultWatchdog);
  bench.say(bench.host.clear());
  EXPECT_EQ(bench.state(), VehicleState::Standing);
  EXPECT_EQ(bench.host.report->faults, 0);
}

TEST(Vehicle, feedsTheWatchdogOnlyWhileBothLoopsRun) {
  VehicleBench bench;
  bench.run(1000);
  EXPECT_NEAR(bench.board.fed, 100, 1);
  bench.board.fed = 0;
  for (int i = 0; i < 100; ++i) bench.vehicle->tick();
  EXPECT_LE(bench.board.fed, 1);
  bench.board.fed = 0;
  for (int i = 0; i < 100; ++i) bench.vehicle->poll();
  EXPECT_EQ(bench.board.fed, 0);
}

TEST(Vehicle, standsAndSaysWhyWhenItsSettingsAreUnreadable) {
  VehicleBench bench;
  bench.board.memory.cells.fill(0xFF);
  bench.switchOn();
  bench.host = TestHost{kUncommissionedAddress, wire::Key{}};
  ASSERT_TRUE(bench.open());
  EXPECT_EQ(bench.host.report->faults & wire::kFaultEeprom, wire::kFaultEeprom);
  bench.say(bench.host.clear());
  bench.drive(200, 0.0, 1000);
  EXPECT_TRUE(bench.plant.standing()) << "whatever Clear says";
  EXPECT_EQ(bench.state(), VehicleState::Faulted);
}

TEST(Vehicle, keepsWhatWasSetOverARestart) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  const auto maxSpeed = static_cast<std::uint8_t>(Parameter::MaxSpeed);
  EXPECT_EQ(bench.ask(MessageType::Get, maxSpeed).value, 500);
  const auto set = bench.ask(MessageType::Set, maxSpeed, 100);
  EXPECT_EQ(set.outcome, Outcome::Done);
  EXPECT_EQ(set.value, 100);
  EXPECT_EQ(bench.ask(MessageType::Set, maxSpeed, 100'000).outcome, Outcome::OutOfRange);
  EXPECT_EQ(bench.ask(MessageType::Get, 99).outcome, Outcome::Unknown);
  bench.drive(400, 0.0, 3000);
  EXPECT_NEAR(bench.plant.speed(), 0.1, 0.01) << "in force at once";
  EXPECT_EQ(bench.ask(MessageType::Do, static_cast<std::uint8_t>(wire::Action::Restart)).outcome, Outcome::Done);
  bench.run(400);
  EXPECT_EQ(bench.board.restarts, 1);
  bench.switchOn();
  ASSERT_TRUE(bench.open(2));
  EXPECT_EQ(bench.host.identity->boot, 2U);
  EXPECT_EQ(bench.ask(MessageType::Get, maxSpeed).value, 100);
}

TEST(Vehicle, hailsAfterARestartAndTakesNoCommandOfTheOldSession) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  bench.switchOn();
  bench.run(200);
  bench.host.hail.reset();
  bench.drive(200, 0.0, 500);
  ASSERT_TRUE(bench.host.hail);
  EXPECT_EQ(bench.host.hail->boot, 2U);
  EXPECT_TRUE(bench.plant.standing());
}

}  // namespace
}  // namespace tessera::firmware::test
