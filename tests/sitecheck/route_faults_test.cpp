#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sitecheck/sites.h"

namespace tessera::sitecheck {
namespace {

using floor::Site;
using floor::ZoneKind;
using testing::HasSubstr;

Site withRoute(std::vector<Point> vertices) {
  Site site = goodFloor();
  site.routes = {{"r", std::move(vertices), Metres{0.2}}};
  return site;
}

TEST(RouteFaults, noWayAtAllAndPointsTwiceInARow) {
  EXPECT_EQ(faultsOf(withRoute({at(1, 1), at(1, 1)}), FaultKind::RouteTooShort).size(), 1U);
  EXPECT_EQ(faultsOf(withRoute({}), FaultKind::RouteTooShort).size(), 1U);
  Site site = withRoute({at(1, 1), at(1, 1), at(2, 1)});
  const auto faults = faultsOf(site, FaultKind::RouteRepeatsPoint);
  ASSERT_EQ(faults.size(), 1U);
  ASSERT_TRUE(mend(faults[0].fix->edit, site));
  EXPECT_EQ(site.routes[0].vertices.size(), 2U);
  site.routes[0] = {"r", {at(1, 1), at(1, 1), at(2, 1), at(2, 1), at(2, 2)}, Metres{0.2}};
  site.routes[0].legSpeeds = {{}, MetresPerSecond{0.1}, {}, {}};
  ASSERT_TRUE(mend(faultsOf(site, FaultKind::RouteRepeatsPoint)[0].fix->edit, site));
  EXPECT_EQ(site.routes[0].legSpeeds, (std::vector<std::optional<MetresPerSecond>>{MetresPerSecond{0.1}, std::nullopt}))
      << "the legs keep their speeds";
  site.routes.push_back(site.routes[0]);
  EXPECT_EQ(faultsOf(site, FaultKind::RouteTwice).size(), 1U);
}

TEST(RouteFaults, outOfTheRunningZone) {
  const auto faults = faultsOf(withRoute({at(1, 1), at(4, 1), at(4, 2), at(1, 2)}), FaultKind::RouteLeavesRunningZone);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_THAT(faults[0].sentence.english(), HasSubstr("3.00 m"));
  EXPECT_NEAR(faults[0].place->low.x.value(), 3.0, 0.01);
  EXPECT_TRUE(faultsOf(withRoute({at(0, 0), at(3, 0)}), FaultKind::RouteLeavesRunningZone).empty()) << "along its edge";
}

TEST(RouteFaults, twoZonesDrawnToOneLineAreOneFloor) {
  Site site = withRoute({at(0.5, 1), at(2.5, 1)});
  site.zones = {zone("west", ZoneKind::Running, rectangle(0, 0, 1.5, 2.4)),
                zone("east", ZoneKind::Storage, rectangle(1.5, 0, 3, 2.4))};
  EXPECT_EQ(listOf(checkSite(site).faults()), "");
}

TEST(RouteFaults, throughNoGo) {
  Site site = withRoute({at(0.5, 1), at(2.5, 1)});
  site.zones.push_back(zone("pit", ZoneKind::NoGo, rectangle(1, 0.9, 1.5, 1.1)));
  const auto faults = faultsOf(site, FaultKind::RouteCrossesNoGo);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_THAT(faults[0].sentence.english(), HasSubstr("\"pit\""));
  EXPECT_EQ(faults[0].objects.size(), 2U);
  EXPECT_TRUE(faultsOf(site, FaultKind::RouteLeavesRunningZone).empty()) << "told once";
}

TEST(RouteFaults, againstAOneWayZone) {
  Site site = withRoute({at(0.5, 1), at(2.5, 1)});
  site.zones.push_back(zone("lane", ZoneKind::OneWay, rectangle(1, 0.5, 2, 1.5)));
  for (const double way : {0.0, 89.0, 90.0, -90.0}) {
    site.zones[1].direction = fromDegrees(way);
    EXPECT_TRUE(faultsOf(site, FaultKind::RouteAgainstOneWay).empty()) << way;
  }
  for (const double way : {91.0, 180.0, -120.0}) {
    site.zones[1].direction = fromDegrees(way);
    const auto faults = faultsOf(site, FaultKind::RouteAgainstOneWay);
    ASSERT_EQ(faults.size(), 1U) << way;
    EXPECT_THAT(faults[0].sentence.english(), HasSubstr("1.00 m the wrong way"));
  }
}

TEST(RouteFaults, tooCloseForTheVehiclesOutline) {
  EXPECT_TRUE(faultsOf(withRoute({at(0.5, 0.19), at(2.5, 0.19)}), FaultKind::RouteTooClose).empty());
  const auto beside = faultsOf(withRoute({at(0.5, 0.1), at(2.5, 0.1)}), FaultKind::RouteTooClose);
  ASSERT_EQ(beside.size(), 1U);
  EXPECT_THAT(beside[0].sentence.english(), HasSubstr("\"AGV 1\""));
  EXPECT_NEAR(beside[0].place->low.y.value(), -0.08, 0.005);
  // Its corners reach out to 0.269 m where it turns on the spot, though along both legs there is room.
  EXPECT_EQ(faultsOf(withRoute({at(1, 0.25), at(2, 0.25), at(2, 1)}), FaultKind::RouteTooClose).size(), 1U);
  EXPECT_TRUE(faultsOf(withRoute({at(1, 0.28), at(2, 0.28), at(2, 1)}), FaultKind::RouteTooClose).empty());
  Site site = withRoute({at(0.5, 1), at(2.5, 1)});
  site.zones.push_back(zone("wall", ZoneKind::NoGo, rectangle(1, 1.1, 2, 2)));
  EXPECT_EQ(faultsOf(site, FaultKind::RouteTooClose).size(), 1U);
  site.zones.erase(site.zones.begin());
  EXPECT_EQ(faultsOf(site, FaultKind::RouteTooClose).size(), 1U) << "without a running zone, no-go still counts";
}

TEST(RouteFaults, aVehicleThatRoundsCornersIsCheckedOnTheWayThatItTakes) {
  // Turning on the spot its corners reach out to 0.269 m, and beyond the floor's edge; round an arc they do not.
  Site site = withRoute({at(1, 0.25), at(2, 0.25), at(2, 1)});
  ASSERT_EQ(faultsOf(site, FaultKind::RouteTooClose).size(), 1U);
  for (floor::VehicleSetup& vehicle : site.vehicles) vehicle.cornerCut = Metres{0.1};
  EXPECT_TRUE(faultsOf(site, FaultKind::RouteTooClose).empty());
  // What stands inside of the corner is in the way of the arc alone.
  Site pillar = withRoute({at(1, 0.28), at(2, 0.28), at(2, 1)});
  pillar.zones.push_back(zone("pillar", ZoneKind::NoGo, rectangle(1.4, 0.52, 1.76, 0.9)));
  EXPECT_TRUE(faultsOf(pillar, FaultKind::RouteTooClose).empty());
  for (floor::VehicleSetup& vehicle : pillar.vehicles) vehicle.cornerCut = Metres{0.2};
  EXPECT_EQ(faultsOf(pillar, FaultKind::RouteTooClose).size(), 1U);
}

Site cutting(Site site, double cut) {
  for (floor::VehicleSetup& vehicle : site.vehicles) vehicle.cornerCut = Metres{cut};
  return site;
}

// Its zone lies inside of the corner at (2, 1), beside both legs; only who rounds that corner comes there.
Site insideACorner(ZoneKind kind) {
  Site site = withRoute({at(0.5, 1), at(0.5, 1), at(2, 1), at(2, 2)});
  site.zones.push_back(zone("inside", kind, rectangle(1.7, 1.06, 1.94, 1.3)));
  site.zones.back().direction = fromDegrees(-90);
  site.zones.back().speed = MetresPerSecond{0.1};
  return site;
}

TEST(RouteFaults, againstAOneWayZoneRoundACorner) {
  const Site site = insideACorner(ZoneKind::OneWay);
  EXPECT_TRUE(faultsOf(site, FaultKind::RouteAgainstOneWay).empty()) << "the line drawn passes it by";
  EXPECT_TRUE(faultsOf(cutting(site, 0.05), FaultKind::RouteAgainstOneWay).empty()) << "and so does a small arc";
  const auto faults = faultsOf(cutting(site, 0.15), FaultKind::RouteAgainstOneWay);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].severity, Severity::Error);
  EXPECT_THAT(faults[0].sentence.english(),
              testing::StartsWith("Rounding the corners of route \"r\", vehicle \"AGV 1\" "));
  EXPECT_THAT(faults[0].sentence.english(), HasSubstr("one-way zone \"inside\", first at vertex 3."));
  EXPECT_EQ(
      faults[0].objects,
      (std::vector<Object>{{ObjectKind::Route, "r"}, {ObjectKind::Zone, "inside"}, {ObjectKind::Vehicle, "AGV 1"}}));
  ASSERT_TRUE(faults[0].place);
  EXPECT_NEAR(faults[0].place->high.x.value(), 2.0, 1e-9) << "as far as the vertex";
  EXPECT_NEAR(faults[0].place->low.y.value(), 1.0, 1e-9);
  EXPECT_GT(faults[0].place->low.x, Metres{1.69});
}

TEST(RouteFaults, ofEachCornerCutAreToldOnce) {
  Site site = cutting(insideACorner(ZoneKind::OneWay), 0.15);
  for (const double cut : {0.15, 0.2, 0.0}) {
    site.vehicles.push_back(site.vehicles[0]);
    site.vehicles.back().name = "another " + std::to_string(cut);
    site.vehicles.back().cornerCut = Metres{cut};
    site.vehicles.back().maxSpeed = MetresPerSecond{0.3};
  }
  EXPECT_EQ(faultsOf(site, FaultKind::RouteAgainstOneWay).size(), 2U);
  site.zones.back().outline = rectangle(1.7, 0.9, 2.1, 1.3);
  const auto faults = faultsOf(site, FaultKind::RouteAgainstOneWay);
  ASSERT_EQ(faults.size(), 1U) << "where the line is wrong itself, it is told of that";
  EXPECT_THAT(faults[0].sentence.english(), HasSubstr("Route \"r\" leads 0.30 m the wrong way"));
}

TEST(RouteFaults, throughNoGoAndOutOfTheFloorRoundACorner) {
  const Site pit = insideACorner(ZoneKind::NoGo);
  EXPECT_TRUE(faultsOf(pit, FaultKind::RouteCrossesNoGo).empty());
  const Site cut = cutting(pit, 0.15);
  ASSERT_EQ(faultsOf(cut, FaultKind::RouteCrossesNoGo).size(), 1U);
  EXPECT_THAT(faultsOf(cut, FaultKind::RouteCrossesNoGo)[0].sentence.english(), HasSubstr("vertex 3"));
  EXPECT_TRUE(faultsOf(cut, FaultKind::RouteLeavesRunningZone).empty()) << "told once";
  EXPECT_TRUE(faultsOf(cut, FaultKind::RouteTooClose).empty()) << "told once";
  // The floor has the shape of the route, and nothing within its corner.
  Site bent = withRoute({at(0.5, 1), at(2, 1), at(2, 2)});
  bent.zones = {zone("low", ZoneKind::Running, rectangle(0, 0.5, 2.5, 1.05)),
                zone("high", ZoneKind::Running, rectangle(1.95, 0.5, 2.5, 2.4))};
  EXPECT_TRUE(faultsOf(bent, FaultKind::RouteLeavesRunningZone).empty());
  const auto out = faultsOf(cutting(bent, 0.15), FaultKind::RouteLeavesRunningZone);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_THAT(out[0].sentence.english(), HasSubstr("outside the zones in which vehicles may be, first at vertex 2."));
}

TEST(RouteFaults, legsThatMayBeDrivenFasterThanASlowZoneInsideACorner) {
  Site site = insideACorner(ZoneKind::Slow);
  site.routes[0].legSpeeds = {MetresPerSecond{0.3}, MetresPerSecond{0.3}, MetresPerSecond{0.1}};
  EXPECT_TRUE(faultsOf(site, FaultKind::RouteFasterThanZone).empty());
  site = cutting(site, 0.15);
  const auto faults = faultsOf(site, FaultKind::RouteFasterThanZone);
  ASSERT_EQ(faults.size(), 1U) << "the leg behind the corner is slow enough";
  EXPECT_EQ(faults[0].sentence.english(),
            "Leg 2 of route \"r\" may be driven at 0.30 m/s, but rounding its corner vehicle \"AGV 1\" comes through "
            "the slow zone \"inside\" of 0.10 m/s.");
  ASSERT_TRUE(mend(faults[0].fix->edit, site));
  EXPECT_TRUE(faultsOf(site, FaultKind::RouteFasterThanZone).empty());
  site.routes[0].legSpeeds = {MetresPerSecond{0.1}, MetresPerSecond{0.1}, MetresPerSecond{0.3}};
  EXPECT_THAT(faultsOf(site, FaultKind::RouteFasterThanZone).at(0).sentence.english(), HasSubstr("Leg 3 of"));
}

TEST(RouteFaults, bendsFasterThanTheVehicleTurns) {
  const auto arc = [](double radius) {
    std::vector<Point> points;
    for (int i = 0; i <= 8; ++i)
      points.push_back(at(1 + radius * std::sin(i * 0.1), 1 + radius * (1 - std::cos(i * 0.1))));
    return points;
  };
  // 0.5 m/s and 1.5 rad/s: a radius of 0.33 m.
  EXPECT_EQ(faultsOf(withRoute(arc(0.30)), FaultKind::RouteTooTight).size(), 1U);
  EXPECT_TRUE(faultsOf(withRoute(arc(0.37)), FaultKind::RouteTooTight).empty());
  Site slow = withRoute(arc(0.30));
  slow.routes[0].legSpeeds.assign(8, MetresPerSecond{0.4});
  EXPECT_TRUE(faultsOf(slow, FaultKind::RouteTooTight).empty()) << "slowly enough for it";
  slow.routes[0].legSpeeds[3].reset();
  EXPECT_EQ(faultsOf(slow, FaultKind::RouteTooTight).size(), 1U) << "but one leg";
  EXPECT_TRUE(faultsOf(withRoute({at(1, 1), at(1.1, 1), at(1.1, 1.1)}), FaultKind::RouteTooTight).empty())
      << "at a sharp corner it stops and turns on the spot";
}

TEST(RouteFaults, legsThatMayBeDrivenFasterThanASlowZone) {
  Site site = withRoute({at(0.5, 1), at(1, 1), at(2.5, 1)});
  site.zones.push_back(zone("slow", ZoneKind::Slow, rectangle(1.5, 0.5, 2, 1.5)));
  site.zones.back().speed = MetresPerSecond{0.1};
  const auto faults = [&] { return faultsOf(site, FaultKind::RouteFasterThanZone); };
  EXPECT_TRUE(faults().empty()) << "as ordered: nobody said how fast";
  site.routes[0].legSpeeds = {MetresPerSecond{0.3}, MetresPerSecond{0.2}};
  ASSERT_EQ(faults().size(), 1U) << "the first leg does not lead there";
  EXPECT_EQ(faults()[0].severity, Severity::Warning);
  EXPECT_EQ(faults()[0].sentence.english(),
            "Leg 2 of route \"r\" may be driven at 0.20 m/s, but leads through the slow zone \"slow\" of 0.10 m/s.");
  EXPECT_NEAR(faults()[0].place->low.x.value(), 1.5, 1e-6);
  ASSERT_TRUE(mend(faults()[0].fix->edit, site));
  EXPECT_TRUE(faults().empty());
  EXPECT_EQ(site.routes[0].legSpeeds[0], MetresPerSecond{0.3});
  EXPECT_EQ(site.routes[0].legSpeeds[1], MetresPerSecond{0.1});
}

TEST(RouteFaults, tooLongWithoutATag) {
  Site site = withRoute({at(0.3, 1.5), at(2.7, 1.5)});
  EXPECT_TRUE(faultsOf(site, FaultKind::RouteWithoutTags).empty());
  site.tiles[11].uids.clear();
  EXPECT_TRUE(faultsOf(site, FaultKind::RouteWithoutTags).empty()) << "one tile is bridged";
  for (const std::size_t tile : {12U, 13U}) site.tiles[tile].uids.clear();
  const auto faults = faultsOf(site, FaultKind::RouteWithoutTags);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_GT(faults[0].place->high.x - faults[0].place->low.x, Metres{1.5});
  site.looseTags = {{floor::TagUid::parse("04AABBCC").value(), at(1.5, 1.5)}};
  EXPECT_TRUE(faultsOf(site, FaultKind::RouteWithoutTags).empty()) << "a loose tag halfway";
  CheckOptions strict;
  strict.longestBlind = Metres{0.5};
  EXPECT_GT(checkSite(site, strict).size(), checkSite(site).size());
}

TEST(RouteFaults, areFoundForAUsualVehicleWhereTheSiteHasNone) {
  Site site = goodFloor();
  for (auto& tile : site.tiles) tile.uids.clear();
  site.vehicles.clear();
  site.routes = {{"r", {at(0.4, 0.05), at(2.0, 0.05), at(2.6, 0.15)}, Metres{0.2}}};
  const auto blind = faultsOf(site, FaultKind::RouteWithoutTags);
  ASSERT_EQ(blind.size(), 1U);
  EXPECT_THAT(blind[0].sentence.english(), HasSubstr("route \"r\" a usual vehicle sees no registered tag"));
  EXPECT_EQ(blind[0].objects, (std::vector<Object>{{ObjectKind::Route, "r"}})) << "there is no vehicle to show";
  const auto close = faultsOf(site, FaultKind::RouteTooClose);
  ASSERT_EQ(close.size(), 1U);
  ASSERT_TRUE(close[0].fix) << close[0].sentence;
  ASSERT_TRUE(mend(close[0].fix->edit, site));
  EXPECT_TRUE(faultsOf(site, FaultKind::RouteTooClose).empty());
  EXPECT_THAT(faultsOf(site, FaultKind::NoVehicle)[0].sentence.english(), HasSubstr("checked for a usual one"));
}

TEST(RouteFaults, aReaderSeesWhatPassesUnderIt) {
  Site site;
  site.vehicles = goodFloor().vehicles;
  site.vehicles[0].readers = {{Metres{0.1}, Metres{0.05}}};
  site.vehicles[0].readerRadius = Metres{0.06};
  site.routes = {{"r", {at(0, 0), at(0, 4)}, Metres{0.2}}};
  // Left of a way upwards is -x; one metre apart, beside the reader by 5 cm or by 7 cm.
  for (const double aside : {0.05, 0.07}) {
    site.looseTags.clear();
    for (int i = 0; i <= 4; ++i)
      site.looseTags.push_back({floor::TagUid::parse("0400000" + std::to_string(i)).value(), at(-0.05 + aside, i)});
    EXPECT_EQ(faultsOf(site, FaultKind::RouteWithoutTags).empty(), aside < 0.06) << aside;
  }
}

}  // namespace
}  // namespace tessera::sitecheck
