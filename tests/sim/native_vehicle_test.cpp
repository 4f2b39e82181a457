// The whole vehicle in one process: the firmware over the host board, in a simulated body, driven by real frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "floor/bearing.h"
#include "sim/commission.h"
#include "sim/commission_bench.h"
#include "sim/native_host.h"
#include "sim/test_floor.h"
#include "sim/vehicle_body.h"

namespace tessera::sim {
namespace {

using wire::CommandMode;
using wire::VehicleState;

constexpr Radians kNorthToY{0.3};
constexpr std::uint8_t kHalfSecond = 25;

VehicleWorldConfig configOf(std::uint64_t seed) {
  VehicleWorldConfig config;
  config.setup = testVehicle();
  config.body = bodyParametersFor(config.setup);
  config.body.compass.bias = Radians{};
  floor::Site site = testSite(40);
  site.northToY = kNorthToY;
  config.map = floor::SiteMap::build(site).value();
  config.northToY = kNorthToY;
  config.start = {{Metres{2.0}, Metres{2.0}}, Radians{}};
  config.seed = seed;
  return config;
}

EepromImage imageFor(const VehicleWorldConfig& config) {
  const auto image = commissionEeprom(config.setup, config.map->site(), config.body, config.seed);
  EXPECT_TRUE(image) << image.error().sentence;
  return image.value_or(EepromImage{});
}

struct NativeVehicle : testing::Test {
  VehicleWorldConfig config = configOf(3);
  NativeHost* host = nullptr;
  std::unique_ptr<VehicleBody> body;
  std::unique_ptr<CommissionBench> bench;
  wire::Identity identity;

  void SetUp() override {
    auto owned = std::make_unique<NativeHost>(imageFor(config));
    host = owned.get();
    body = std::make_unique<VehicleBody>(config, std::move(owned));
    ASSERT_TRUE(body->start(Seconds{}));
    bench = std::make_unique<CommissionBench>(*body, config.setup.key, Seconds{});
    const auto opened = bench->open();
    ASSERT_TRUE(opened) << opened.error().sentence;
    identity = *opened;
    bench->run(Seconds{2.0});  // the heading settles on the compass
  }
  static wire::CycleEntry drive(double speed, double heading) {
    wire::CycleEntry entry;
    entry.mode = CommandMode::Drive;
    entry.speed = static_cast<std::int16_t>(std::lround(speed * 1000));
    entry.bearing = floor::toBinaryAngle(floor::bearingOfHeading(Radians{heading}, kNorthToY));
    entry.expiry = kHalfSecond;
    return entry;
  }
  wire::Report stop() {
    const auto report = bench->keepCommanding({0, CommandMode::Stop}, Seconds{1.5});
    EXPECT_TRUE(report);
    return report.value_or(wire::Report{});
  }
};

TEST_F(NativeVehicle, identifiesItself) {
  EXPECT_EQ(identity.hardware, 2);
  EXPECT_EQ(identity.protocol, wire::kProtocolVersion);
  EXPECT_EQ(identity.readers, 3);
  EXPECT_EQ(identity.rangers, 2);
}

TEST_F(NativeVehicle, drivesStraightForAMetreAndStops) {
  const auto before = bench->poll();
  ASSERT_TRUE(before);
  const Pose start = body->pose();
  bench->keepCommanding(drive(0.2, 0.0), Seconds{5.2});
  const wire::Report report = stop();
  const Offset way = body->pose().position - start.position;
  EXPECT_NEAR(way.x.value(), 1.0, 0.08);
  EXPECT_NEAR(way.y.value(), 0.0, 0.05);
  EXPECT_EQ(body->speed().value(), 0.0);
  EXPECT_EQ(report.state, VehicleState::Standing);
  const auto travelled = static_cast<std::uint16_t>(report.travel - before->travel);
  EXPECT_NEAR(travelled / 1000.0, length(way).value(), 0.05);
}

TEST_F(NativeVehicle, turnsByNinetyDegreesOnTheSpot) {
  const Pose start = body->pose();
  bench->keepCommanding(drive(0.0, kPi / 2), Seconds{5.0});
  EXPECT_NEAR(degrees(body->pose().heading), 90.0, 3.0);
  EXPECT_LT(distance(body->pose().position, start.position).value(), 0.05);
  const auto report = bench->poll();
  ASSERT_TRUE(report);
  const Radians told = floor::headingOfBearing(floor::fromBinaryAngle(report->bearing), kNorthToY);
  EXPECT_NEAR(degrees(turnBetween(body->pose().heading, told)), 0.0, 3.0);
}

TEST_F(NativeVehicle, standsWhileOneOfItsRangersIsDead) {
  ASSERT_TRUE(bench->keepCommanding(drive(0.2, 0.0), Seconds{2.0}));
  EXPECT_GT(body->speed().value(), 0.15);
  body->rangers().setDead(0, true);
  bench->keepCommanding(drive(0.2, 0.0), Seconds{2.0});
  EXPECT_EQ(body->speed().value(), 0.0);
  auto report = bench->poll();
  ASSERT_TRUE(report);
  EXPECT_EQ(report->state, VehicleState::Obstacle);
  EXPECT_EQ(report->faults, wire::kFaultRanger);
  body->rangers().setDead(0, false);
  bench->keepCommanding(drive(0.2, 0.0), Seconds{2.5});
  EXPECT_GT(body->speed().value(), 0.15);
  report = bench->poll();
  ASSERT_TRUE(report);
  EXPECT_EQ(report->faults, 0);
}

TEST_F(NativeVehicle, stopsByItselfWhenCommandsStopComing) {
  ASSERT_TRUE(bench->keepCommanding(drive(0.3, 0.0), Seconds{2.0}));
  EXPECT_GT(body->speed().value(), 0.25);
  // The last command came less than 0.1 s ago and runs for 0.5 s; then the vehicle brakes, at 0.5 m/s² at the least.
  const Point last = body->pose().position;
  bench->run(Seconds{1.2});
  EXPECT_EQ(body->speed().value(), 0.0);
  EXPECT_LT(distance(body->pose().position, last).value(), 0.3 * 0.5 + 0.3 * 0.3 / (2 * 0.5) + 0.03);
  const auto report = bench->poll();
  ASSERT_TRUE(report);
  EXPECT_EQ(report->state, VehicleState::Expired);
}

TEST_F(NativeVehicle, reportsTheTagsThatItCrosses) {
  std::set<floor::TagUid> read;
  wire::CycleEntry entry = drive(0.2, 0.0);
  for (int i = 0; i < 60; ++i) {
    const auto report = bench->command(entry);
    bench->run(Seconds{0.1});
    if (!report) continue;
    for (std::size_t e = 0; e < report->eventCount; ++e) {
      const wire::TagEvent& event = report->events[e];
      if (event.kind == wire::EventKind::Left) continue;
      const auto uid = floor::TagUid::fromBytes(std::span{event.uid}.first(wire::uidLength(event.kind)));
      ASSERT_TRUE(uid && config.map->find(*uid));
      read.insert(*uid);
    }
    entry.nextEvent = static_cast<std::uint8_t>(report->firstEvent + report->eventCount);
  }
  // 1.2 m: a row of three readers of 12 cm each, 0.31 m wide together, sweeps some eight tags.
  EXPECT_GE(read.size(), 5U);
}

TEST_F(NativeVehicle, namesAReaderThatDoesNotAnswer) {
  body->readers().setDead(1, true);
  bench->run(Seconds{2.0});
  const auto report = bench->poll();
  ASSERT_TRUE(report);
  EXPECT_EQ(report->readers, 0b101);
  EXPECT_NE(report->faults & wire::kFaultReader, 0);
}

TEST_F(NativeVehicle, stopsWithAFaultWhenAWheelIsJammedUntilItIsCleared) {
  body->plant().setBlocked(0, true);
  auto report = bench->keepCommanding(drive(0.3, 0.0), Seconds{3.0});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->state, VehicleState::Faulted);
  EXPECT_NE(report->faults & wire::kFaultMotorStall, 0);
  EXPECT_EQ(body->duty(), (std::array<int, 2>{}));
  body->plant().setBlocked(0, false);
  ASSERT_TRUE(bench->command({0, CommandMode::Clear}));
  report = bench->keepCommanding(drive(0.3, 0.0), Seconds{3.0});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->state, VehicleState::Driving);
  EXPECT_EQ(report->faults & wire::kFaultMotorStall, 0);
}

TEST_F(NativeVehicle, keepsItsHeadingFromTheWheelsWhenTheCompassFallsSilent) {
  host->board().setCompassPresent(false);
  bench->keepCommanding(drive(0.2, 0.0), Seconds{5.0});
  const auto report = bench->poll();
  ASSERT_TRUE(report);
  EXPECT_NE(report->faults & wire::kFaultCompass, 0);
  EXPECT_NEAR(degrees(body->pose().heading), 0.0, 6.0);
  EXPECT_GT(body->pose().position.x.value(), 2.8);
}

TEST_F(NativeVehicle, isTurnedByHandAndFindsItsBearingByTheCompass) {
  body->setPose({body->pose().position, Radians{2.0}});
  bench->run(Seconds{10.0});
  const auto report = bench->poll();
  ASSERT_TRUE(report);
  const Radians told = floor::headingOfBearing(floor::fromBinaryAngle(report->bearing), kNorthToY);
  EXPECT_NEAR(degrees(turnBetween(body->pose().heading, told)), 0.0, 3.0);
}

TEST_F(NativeVehicle, reportsItsBattery) {
  const auto report = bench->poll();
  ASSERT_TRUE(report);
  EXPECT_NEAR(report->battery / 10.0, body->batteryVolts(), 0.15);
}

TEST_F(NativeVehicle, stopsBeforeAWallAndGoesOnWhenItIsGone) {
  const Metres wall = body->pose().position.x + Metres{1.5};
  body->setScene({{{{wall, Metres{-9.0}}, {wall, Metres{9.0}}}}, {}});
  auto report = bench->keepCommanding(drive(0.3, 0.0), Seconds{8.0});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->state, VehicleState::Obstacle);
  EXPECT_EQ(body->speed().value(), 0.0);
  EXPECT_LT(body->pose().position.x.value() + 0.20, wall.value());
  body->setScene({});
  report = bench->keepCommanding(drive(0.3, 0.0), Seconds{4.0});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->state, VehicleState::Driving);
  EXPECT_GT(body->pose().position.x.value(), wall.value());
}

TEST_F(NativeVehicle, countsItsStartsAndForgetsItsSessionWhenItIsSwitchedOff) {
  body->host().kill();
  bench->run(Seconds{0.2});
  EXPECT_FALSE(body->host().running());
  ASSERT_TRUE(body->host().start(bench->now()));
  bench->run(Seconds{1.0});
  EXPECT_FALSE(bench->poll());
  const auto again = bench->open();
  ASSERT_TRUE(again);
  EXPECT_EQ(again->boot, identity.boot + 1);
  EXPECT_TRUE(bench->poll());
}

TEST_F(NativeVehicle, restartsWhenItIsToldTo) {
  const int before = host->starts();
  bench->request({wire::MessageType::Do, static_cast<std::uint8_t>(wire::Action::Restart)});
  EXPECT_TRUE(bench->runUntil([&] { return host->starts() == before + 1; }, Seconds{2.0}));
  bench->run(Seconds{1.0});
  EXPECT_TRUE(bench->open());
}

TEST_F(NativeVehicle, refusesAFrameThatItHasSeenBefore) {
  ASSERT_TRUE(bench->command(drive(0.2, 0.0)));
  const std::vector<std::uint8_t> recorded = bench->lastSent();
  ASSERT_TRUE(bench->command({0, CommandMode::Stop}));
  bench->send(recorded);
  bench->run(Seconds{1.0});
  EXPECT_EQ(body->speed().value(), 0.0);
  const auto report = bench->poll();
  ASSERT_TRUE(report);
  EXPECT_NE(report->faults & wire::kFaultReplayed, 0);
}

TEST(NativeVehicles, repeatThemselvesBitByBitForTheSameSeed) {
  const auto run = [](std::uint64_t seed) {
    const VehicleWorldConfig config = configOf(seed);
    VehicleBody body{config, std::make_unique<NativeHost>(imageFor(config))};
    EXPECT_TRUE(body.start(Seconds{}));
    CommissionBench bench{body, config.setup.key, Seconds{}};
    EXPECT_TRUE(bench.open());
    bench.keepCommanding(NativeVehicle::drive(0.25, 1.0), Seconds{4.0});
    return body.pose();
  };
  EXPECT_EQ(run(11), run(11));
  EXPECT_NE(run(11), run(12));
}

}  // namespace
}  // namespace tessera::sim
