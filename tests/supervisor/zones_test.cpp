// What zones mean for orders, and what the operator is told.
#include <gtest/gtest.h>

#include "drive/route_follower.h"
#include "supervisor/supervisor_fixture.h"

namespace tessera::supervisor {
namespace {

using floor::ZoneKind;
using test::siteMap;
using test::SupervisorRig;

Point spot(double x, double y) { return {Metres{x}, Metres{y}}; }

floor::Zone bandOf(ZoneKind kind, double low, double high) {
  return {"aisle", kind, {spot(0, low), spot(2.3, low), spot(2.3, high), spot(0, high)}, {}, {}};
}

std::shared_ptr<const floor::SiteMap> with(const floor::Zone& zone) {
  floor::Site site = siteMap("three.tessera.json")->site();
  site.zones.push_back(zone);
  return floor::SiteMap::build(std::move(site)).value();
}

TEST(OneWayZones, refuseARouteThatLeadsAgainstThem) {
  floor::Zone aisle = bandOf(ZoneKind::OneWay, 1.0, 2.0);
  aisle.direction = Radians{kPi / 2};
  SupervisorRig rig{with(aisle)};
  rig.runRoute(1, "one", 0.2);  // up, and down again beside it
  rig.runRoute(2, "two", 0.2);  // up
  rig.run(Seconds{0.5});
  const auto refused = rig.told(EventKind::OrderRefused);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].sentence, "AGV 1: the route one leads 1.00 m the wrong way through the one-way zone aisle.");
  EXPECT_EQ(rig.view(1).task, Task::None);
  EXPECT_EQ(rig.view(2).task, Task::Running);
}

// Around a corner that vehicle 1 may cut by so much; the zone lies within it, beside both legs.
std::shared_ptr<const floor::SiteMap> insideACorner(ZoneKind kind, double cut) {
  floor::Site site = siteMap("three.tessera.json")->site();
  floor::Route corner{"corner", {site.vehicles[0].start->position}, Metres{0.2}};
  const Point start = corner.vertices[0];
  const Point vertex = start + Offset{{}, Metres{1.0}};
  corner.vertices.insert(corner.vertices.end(), {vertex, vertex + Offset{Metres{1.0}, {}}});
  site.routes.push_back(corner);
  for (floor::VehicleSetup& vehicle : site.vehicles) vehicle.cornerCut = Metres{cut};
  const auto inside = [&](double x, double y) { return vertex + Offset{Metres{x}, Metres{-y}}; };
  site.zones.push_back(
      {"inside", kind, {inside(0.06, 0.06), inside(0.06, 0.3), inside(0.3, 0.3), inside(0.3, 0.06)}, {}, {}});
  site.zones.back().direction = Radians{-kPi / 2};
  site.zones.back().speed = MetresPerSecond{0.04};
  return floor::SiteMap::build(std::move(site)).value();
}

TEST(OneWayZones, refuseARouteThatLeadsAgainstThemRoundACorner) {
  for (const double cut : {0.0, 0.15}) {
    SupervisorRig rig{insideACorner(ZoneKind::OneWay, cut)};
    rig.runRoute(1, "corner", 0.2);
    rig.run(Seconds{0.5});
    EXPECT_EQ(rig.told(EventKind::OrderRefused).size(), cut > 0.0 ? 1U : 0U) << "the line drawn passes it by";
  }
}

TEST(OneWayZones, areNotMetRoundACornerByAControllerThatRoundsNone) {
  for (const std::string_view controller : drive::followerNames()) {
    const auto map = insideACorner(ZoneKind::OneWay, 0.15);
    Config config;
    config.controller = controller;
    SupervisorRig rig{map, SupervisorRig::defaults(), config};
    rig.runRoute(1, "corner", 0.2);
    rig.run(Seconds{0.5});
    EXPECT_EQ(rig.told(EventKind::OrderRefused).empty(), !drive::roundsCorners(controller)) << controller;
    EXPECT_EQ(rig.view(1).task == Task::Running, !drive::roundsCorners(controller)) << controller;
  }
}

TEST(SlowZones, areDrivenThroughSlowlyRoundACorner) {
  const auto map = insideACorner(ZoneKind::Slow, 0.15);
  const Point vertex = map->route("corner")->vertices[1];
  SupervisorRig rig{map};
  rig.runRoute(1, "corner", 0.2);
  double fastest = 0.0;
  double nearest = 1e9;
  bool inside = false;
  ASSERT_TRUE(rig.runUntil(
      [&] {
        const Offset from = rig.vehicle(1).pose.position - vertex;
        nearest = std::min(nearest, length(from).value());
        if (from.x > Metres{0.06} && from.x < Metres{0.3} && from.y < Metres{-0.06} && from.y > Metres{-0.3}) {
          inside = true;
          fastest = std::max(fastest, rig.vehicle(1).speed);
        }
        return rig.last && rig.view(1).finished;
      },
      Seconds{120}))
      << rig.view(1).doing;
  EXPECT_TRUE(inside) << "it cuts the corner";
  EXPECT_NEAR(nearest, 0.15, 0.05);
  EXPECT_LT(fastest, 0.055);
  EXPECT_NEAR(rig.view(1).length.value(), 2.0, 1e-9) << "as drawn";
  EXPECT_NEAR(rig.view(1).progress.value(), 2.0, 0.02);
}

class SingleVehicleZone : public testing::Test {
protected:
  static constexpr const char* kDrivesThrough =
      "AGV 2 waits before the single-vehicle zone aisle: AGV 1 drives through it.";
  static constexpr const char* kIsIn = "AGV 2 waits before the single-vehicle zone aisle: AGV 1 is in it.";

  bool saidOf(std::uint8_t id, const char* sentence, double limit = 30) {
    return rig.runUntil([&] { return rig.last && rig.view(id).waits == sentence; }, Seconds{limit});
  }
  bool moves(std::uint8_t id) {
    return rig.runUntil([&] { return rig.vehicle(id).speed > 0.1; }, Seconds{10});
  }
  SupervisorRig rig{with(bandOf(ZoneKind::SingleVehicle, 1.0, 1.4))};
};

TEST_F(SingleVehicleZone, letsTheSecondWaitAndSaysWhy) {
  rig.runRoute(1, "one", 0.2);
  rig.runRoute(2, "two", 0.2);
  EXPECT_TRUE(saidOf(2, kDrivesThrough));
  EXPECT_TRUE(saidOf(2, kIsIn));
  EXPECT_TRUE(rig.runUntil([&] { return rig.vehicle(2).speed == 0.0; }, Seconds{3})) << "it may be braking still";
  EXPECT_LT(rig.vehicle(2).pose.position.y.value() + 0.2, 1.0) << "its nose is outside";
  EXPECT_EQ(rig.view(2).doing, "Waiting until the way ahead is free.");
  EXPECT_TRUE(rig.runUntil([&] { return rig.view(2).finished; }, Seconds{120})) << rig.view(2).waits;
}

TEST_F(SingleVehicleZone, isKeptByAVehicleThatPausesAndGivenUpByOneThatStopsBeforeIt) {
  rig.runRoute(1, "one", 0.2);
  rig.runRoute(2, "two", 0.2);
  // It has the right already, and can still stop outside.
  ASSERT_TRUE(rig.runUntil([&] { return rig.vehicle(1).pose.position.y.value() > 0.58; }, Seconds{30}));
  rig.supervisor.post(Pause{VehicleId{1}});
  rig.run(Seconds{10});
  EXPECT_EQ(rig.view(2).waits, kDrivesThrough);
  ASSERT_LT(rig.vehicle(1).pose.position.y.value() + 0.2, 1.0) << "it has not come into the zone";
  rig.supervisor.post(Stop{VehicleId{1}});
  EXPECT_TRUE(moves(2));
}

TEST_F(SingleVehicleZone, isHeldByAVehicleThatWasStoppedInIt) {
  rig.runRoute(1, "one", 0.2);
  ASSERT_TRUE(rig.runUntil([&] { return rig.vehicle(1).pose.position.y.value() > 1.1; }, Seconds{30}));
  rig.supervisor.post(Stop{VehicleId{1}});
  rig.runRoute(2, "two", 0.2);
  EXPECT_TRUE(saidOf(2, kIsIn));
  rig.run(Seconds{20});
  EXPECT_EQ(rig.view(2).waits, kIsIn);
  rig.runRoute(1, "one", 0.2);
  EXPECT_TRUE(rig.runUntil([&] { return rig.view(2).finished; }, Seconds{120})) << rig.view(2).waits;
}

TEST_F(SingleVehicleZone, thatIsDrawnWhileVehiclesDriveBindsThemAtOnce) {
  rig.supervisor.post(UseSite{siteMap("three.tessera.json")});
  rig.runRoute(1, "one", 0.2);
  ASSERT_TRUE(rig.runUntil([&] { return rig.vehicle(1).pose.position.y.value() > 1.1; }, Seconds{30}));
  rig.supervisor.post(Pause{VehicleId{1}});
  rig.runRoute(2, "two", 0.2);
  ASSERT_TRUE(moves(2));
  rig.supervisor.post(UseSite{rig.map});
  EXPECT_TRUE(saidOf(2, kIsIn));
  EXPECT_LT(rig.vehicle(2).pose.position.y.value() + 0.2, 1.0);
}

}  // namespace
}  // namespace tessera::supervisor
