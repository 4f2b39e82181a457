#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sitecheck/outline.h"
#include "sitecheck/sites.h"

namespace tessera::sitecheck {
namespace {

using floor::Site;
using floor::ZoneKind;
using testing::HasSubstr;

Faults with(const floor::Zone& extra, FaultKind kind) {
  Site site = goodFloor();
  site.zones.push_back(extra);
  return faultsOf(site, kind);
}

TEST(ZoneFaults, anOutlineThatCrossesItselfIsShownWhereItDoes) {
  const auto faults =
      with(zone("8", ZoneKind::Storage, {at(0, 0), at(2, 2), at(2, 0), at(0, 2)}), FaultKind::ZoneCrossesItself);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NEAR(faults[0].place->low.x.value(), 1.0, 1e-6);
  EXPECT_NEAR(faults[0].place->low.y.value(), 1.0, 1e-6);
  // Through a corner, without any two edges that cross properly.
  EXPECT_EQ(with(zone("8", ZoneKind::Storage, {at(0, 0), at(1, 1), at(2, 2), at(2, 0), at(1, 1), at(0, 2)}),
                 FaultKind::ZoneCrossesItself)
                .size(),
            1U);
}

TEST(ZoneFaults, aManyCorneredOutlineDoesNotCrossItself) {
  std::vector<Point> star;
  for (int i = 0; i < 2000; ++i) {
    const double r = i % 2 == 0 ? 1.0 : 0.8;
    star.push_back(at(1.5 + r * std::cos(i * kPi / 1000), 1.2 + r * std::sin(i * kPi / 1000)));
  }
  EXPECT_FALSE(firstCrossing(star));
  std::swap(star[100], star[600]);
  EXPECT_TRUE(firstCrossing(star));
}

TEST(ZoneFaults, noAreaAtAll) {
  EXPECT_EQ(with(zone("line", ZoneKind::Parking, {at(0, 0), at(1, 1), at(2, 2)}), FaultKind::ZoneWithoutArea).size(),
            1U);
  EXPECT_EQ(with(zone("none", ZoneKind::Parking, {}), FaultKind::ZoneWithoutArea).size(), 1U);
}

TEST(ZoneFaults, aPointTwiceInARowIsTakenOut) {
  Site site = goodFloor();
  site.zones[0].outline.push_back(site.zones[0].outline.front());
  const auto faults = faultsOf(site, FaultKind::ZoneRepeatsPoint);
  ASSERT_EQ(faults.size(), 1U);
  ASSERT_TRUE(mend(faults[0].fix->edit, site));
  EXPECT_EQ(site, goodFloor());
}

TEST(ZoneFaults, aSlowZoneWithoutSpeedAndAOneWayZoneWithoutDirection) {
  EXPECT_EQ(with(zone("s", ZoneKind::Slow, rectangle(0, 0, 1, 1)), FaultKind::ZoneWithoutSpeed).size(), 1U);
  EXPECT_EQ(with(zone("o", ZoneKind::OneWay, rectangle(0, 0, 1, 1)), FaultKind::ZoneWithoutDirection).size(), 1U);
  EXPECT_EQ(with(zone("Floor", ZoneKind::Parking, rectangle(0, 0, 1, 1)), FaultKind::ZoneTwice).size(), 1U);
}

TEST(ZoneFaults, aHoleInTheFloorOfARunningZoneWithItsArea) {
  Site site = goodFloor();
  site.placements.erase(site.placements.begin() + 12);
  site.placements.erase(site.placements.begin() + 6);
  const auto faults = faultsOf(site, FaultKind::ZoneGap);
  ASSERT_EQ(faults.size(), 2U) << "they meet in a corner only" << listOf(faults);
  EXPECT_THAT(faults[0].sentence.english(), HasSubstr("0.36 m²"));
  EXPECT_NEAR(faults[0].place->low.x.value(), 0.6, 1e-4);
  EXPECT_NEAR(faults[1].place->high.y.value(), 1.8, 1e-4);
}

TEST(ZoneFaults, seamsOfCentimetresAndPillarsAreNoHoles) {
  Site site = goodFloor();
  for (std::size_t i = 0; i < site.placements.size(); ++i)
    site.placements[i].origin = site.placements[i].origin + Offset{Metres{0.01} * static_cast<double>(i % 5), {}};
  EXPECT_TRUE(faultsOf(site, FaultKind::ZoneGap).empty());
  site = goodFloor();
  site.placements.erase(site.placements.begin() + 12);
  site.zones.push_back(zone("pillar", ZoneKind::NoGo, rectangle(1.2, 1.2, 1.8, 1.8)));
  EXPECT_TRUE(faultsOf(site, FaultKind::ZoneGap).empty());
}

TEST(ZoneFaults, noGoWinsOverWhatItCovers) {
  Site site = goodFloor();
  site.zones.push_back(zone("P", ZoneKind::Parking, rectangle(0, 0, 1, 1)));
  site.zones.push_back(zone("N", ZoneKind::NoGo, rectangle(0.5, 0, 1, 1)));
  auto faults = faultsOf(site, FaultKind::ZonesContradict);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].severity, Severity::Warning);
  EXPECT_THAT(faults[0].sentence.english(), HasSubstr("0.50 m²"));
  site.zones.back().outline = rectangle(0, 0, 1, 1);
  faults = faultsOf(site, FaultKind::ZonesContradict);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].severity, Severity::Error);
  site.zones[1].kind = ZoneKind::Slow;
  EXPECT_EQ(faultsOf(site, FaultKind::ZonesContradict).front().severity, Severity::Warning) << "no effect, no harm";
}

TEST(ZoneFaults, oneWaysThatLeadAgainstOneAnother) {
  Site site = goodFloor();
  site.zones.push_back(zone("east", ZoneKind::OneWay, rectangle(0, 0, 1, 1)));
  site.zones.push_back(zone("other", ZoneKind::OneWay, rectangle(0.5, 0, 2, 1)));
  site.zones[1].direction = fromDegrees(0);
  for (const double way : {0.0, 45.0, 90.0, -90.0}) {
    site.zones[2].direction = fromDegrees(way);
    EXPECT_TRUE(faultsOf(site, FaultKind::ZonesContradict).empty()) << way;
  }
  for (const double way : {91.0, 180.0, -135.0}) {
    site.zones[2].direction = fromDegrees(way);
    EXPECT_EQ(faultsOf(site, FaultKind::ZonesContradict).size(), 1U) << way;
  }
}

TEST(ZoneFaults, aParkingPlaceThatNoWayLeadsTo) {
  Site site = goodFloor();
  const auto unreachable = [&](std::vector<Point> outline) {
    site.zones.resize(1);
    site.zones.push_back(zone("P", ZoneKind::Parking, std::move(outline)));
    return faultsOf(site, FaultKind::ZoneUnreachable).size();
  };
  EXPECT_EQ(unreachable(rectangle(1, 1, 2, 2)), 0U) << "inside";
  EXPECT_EQ(unreachable(rectangle(3, 1, 4, 2)), 0U) << "edge to edge with the running zone";
  EXPECT_EQ(unreachable(rectangle(3.5, 1, 4, 2)), 1U) << "apart";
  EXPECT_EQ(unreachable(rectangle(3, 2.4, 4, 3)), 1U) << "corner to corner";
  EXPECT_EQ(unreachable(rectangle(3, 2.35, 4, 3)), 1U) << "a passage of 5 cm";
  site.zones[1].outline = rectangle(3, 1, 4, 2);
  site.zones.push_back(zone("barrier", ZoneKind::NoGo, rectangle(2.8, 0, 3.1, 3)));
  EXPECT_EQ(faultsOf(site, FaultKind::ZoneUnreachable).size(), 1U) << "no-go before it";
  site.zones.push_back(zone("C", ZoneKind::Charging, rectangle(4, 1, 5, 2)));
  EXPECT_EQ(faultsOf(site, FaultKind::ZoneUnreachable).size(), 2U) << "nor what lies behind";
}

}  // namespace
}  // namespace tessera::sitecheck
