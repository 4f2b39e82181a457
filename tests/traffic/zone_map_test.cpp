// Where ways and bodies meet zones.
#include "traffic/zone_map.h"

#include <gmock/gmock.h>

#include "base/angle.h"
#include "traffic/parts.h"

namespace tessera::traffic {
namespace {

using floor::ZoneKind;

floor::Zone zone(ZoneKind kind, double x0, double y0, double x1, double y1, const std::string& name = "zone") {
  return {name, kind, {at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)}, std::nullopt, std::nullopt};
}
floor::Zone slow(double speed, double x0, double x1) {
  floor::Zone z = zone(ZoneKind::Slow, x0, -1, x1, 1);
  z.speed = MetresPerSecond{speed};
  return z;
}
const double kRoom = kClearance.value();

TEST(BodyBox, isAroundTheFootprint) {
  floor::VehicleSetup setup;
  setup.footprint = {at(0.3, 0), at(-0.1, 0.2), at(-0.1, -0.25)};
  const BodyBox box = bodyBoxOf(setup);
  EXPECT_EQ(box.front, Metres{0.3});
  EXPECT_EQ(box.back, Metres{0.1});
  EXPECT_EQ(box.left, Metres{0.2});
  EXPECT_EQ(box.right, Metres{0.25});
  setup.footprint.clear();
  EXPECT_GT(bodyBoxOf(setup).left, Metres{0.1}) << "its wheels at least";
}

TEST(SlowZones, holdFromTheNoseThatEntersToTheTailThatLeaves) {
  const std::vector zones{slow(0.1, 1, 2)};
  const auto limits = ZoneMap{zones}.slowStretches(Polyline{{at(0, 0), at(4, 0)}}, kBody);
  ASSERT_EQ(limits.stretches().size(), 1U);
  EXPECT_NEAR(limits.stretches()[0].from.value(), 1 - 0.30 - kRoom, 1e-5);
  EXPECT_NEAR(limits.stretches()[0].to.value(), 2 + 0.10 + kRoom, 1e-5);
  EXPECT_EQ(limits.stretches()[0].speed, MetresPerSecond{0.1});
}

TEST(SlowZones, holdForAPartOfTheBodyBesideTheWay) {
  std::vector zones{slow(0.1, 1, 2)};
  zones[0].outline = zone(ZoneKind::Slow, 1, 0.22, 2, 1).outline;
  EXPECT_EQ(ZoneMap{zones}.slowStretches(Polyline{{at(0, 0), at(4, 0)}}, kBody).stretches().size(), 1U)
      << "its left side comes within the clearance";
  zones[0].outline = zone(ZoneKind::Slow, 1, 0.26, 2, 1).outline;
  EXPECT_TRUE(ZoneMap{zones}.slowStretches(Polyline{{at(0, 0), at(4, 0)}}, kBody).stretches().empty());
}

TEST(SlowZones, thatOverlapHoldByTheLowestSpeed) {
  const std::vector zones{slow(0.2, 1, 3), slow(0.1, 2, 4)};
  const auto limits = ZoneMap{zones}.slowStretches(Polyline{{at(0, 0), at(6, 0)}}, kBody);
  ASSERT_EQ(limits.stretches().size(), 2U);
  EXPECT_EQ(limits.stretches()[0].speed, MetresPerSecond{0.2});
  EXPECT_EQ(limits.stretches()[1].speed, MetresPerSecond{0.1});
  EXPECT_NEAR(limits.stretches()[1].from.value(), 2 - 0.30 - kRoom, 1e-5);
}

TEST(SlowZones, areFoundOnTheWayBackAsWell) {
  const std::vector zones{slow(0.1, 1, 2)};
  const auto limits = ZoneMap{zones}.slowStretches(Polyline{{at(0, 0), at(4, 0), at(0, 0)}}, kBody);
  ASSERT_EQ(limits.stretches().size(), 2U);
  EXPECT_NEAR(limits.stretches()[1].from.value(), 4 + 2 - 0.30 - kRoom, 1e-5);
}

TEST(OneWayZones, refuseWaysThatLeadBackThroughThem) {
  floor::Zone oneWay = zone(ZoneKind::OneWay, 1, -1, 2, 1, "aisle");
  oneWay.direction = Radians{0};
  const std::vector zones{oneWay};
  const ZoneMap map{zones};
  EXPECT_FALSE(map.wrongWay(Polyline{{at(0, 0), at(4, 0)}}));
  EXPECT_FALSE(map.wrongWay(Polyline{{at(1.5, -2), at(1.5, 2)}})) << "straight across is allowed";
  EXPECT_FALSE(map.wrongWay(Polyline{{at(4, 1.5), at(0, 1.5)}})) << "beside it";
  const auto wrong = map.wrongWay(Polyline{{at(4, 0), at(0, 0)}});
  ASSERT_TRUE(wrong);
  EXPECT_EQ(wrong->zone, "aisle");
  EXPECT_NEAR(wrong->length.value(), 1.0, 1e-6);
}

TEST(SingleVehicleZones, areMetByTurnsOnTheSpotBesideThem) {
  // Straight on it passes at 25 cm; its nose, when it turns, comes as far as 30 cm and more.
  const std::vector zones{zone(ZoneKind::SingleVehicle, 1, 0.26, 3, 1)};
  const ZoneMap map{zones};
  EXPECT_TRUE(map.crossings(Polyline{{at(0, 0), at(6, 0)}}, kBody).empty());
  const auto turning = map.crossings(Polyline{{at(0, 0), at(2, 0), at(2, -2)}}, kBody);
  ASSERT_FALSE(turning.empty());
  EXPECT_LE(turning.front().from, Metres{2});
  EXPECT_GE(turning.back().to, Metres{2});
}

TEST(SingleVehicleZones, areKnownByWhoStandsInThem) {
  const std::vector zones{zone(ZoneKind::SingleVehicle, 1, -1, 2, 1), zone(ZoneKind::SingleVehicle, 1.5, -1, 3, 1)};
  const ZoneMap map{zones};
  EXPECT_TRUE(map.zonesUnder({at(0.5, 0), Radians{0}}, kBody).empty());
  EXPECT_THAT(map.zonesUnder({at(0.8, 0), Radians{0}}, kBody), testing::ElementsAre(0U));
  EXPECT_TRUE(map.zonesUnder({at(0.8, 0), Radians{kPi}}, kBody).empty()) << "it faces the other way";
  EXPECT_THAT(map.zonesUnder({at(1.8, 0), Radians{1}}, kBody), testing::ElementsAre(0U, 1U));
}

TEST(ZoneMap, bearsZonesThatAreNone) {
  floor::Zone empty = zone(ZoneKind::SingleVehicle, 0, 0, 0, 0);
  floor::Zone speedless = zone(ZoneKind::Slow, 0, 0, 1, 1);
  floor::Zone aimless = zone(ZoneKind::OneWay, 0, 0, 1, 1);
  const std::vector zones{empty, speedless, aimless};
  const ZoneMap map{zones};
  EXPECT_EQ(map.singleCount(), 0U);
  EXPECT_TRUE(map.slowStretches(Polyline{{at(0, 0), at(1, 1)}}, kBody).stretches().empty());
  EXPECT_FALSE(map.wrongWay(Polyline{{at(0, 0), at(1, 1)}}));
}

}  // namespace
}  // namespace tessera::traffic
