#include "sitediff/figures.h"

#include <gtest/gtest.h>

#include "sitecheck/sites.h"

namespace tessera::sitediff {
namespace {

using sitecheck::at;
using sitecheck::goodFloor;

TEST(Figures, countTilesTagsAndAreas) {
  floor::Site site = goodFloor();
  site.tiles[0].uids[3] = {};
  site.tiles.push_back({"spare", site.tileTypes[0].name, {}});
  const Figures f = figuresOf(site);
  EXPECT_EQ(f.tilesKnown, 21U);
  EXPECT_EQ(f.tilesLaid, 20U);
  EXPECT_EQ(f.tagPlaces, 160U);
  EXPECT_EQ(f.registered, 159U);
  EXPECT_NEAR(f.floorSquareMetres, 20 * 0.36, 1e-6);
  ASSERT_EQ(f.zones.size(), 1U);
  EXPECT_NEAR(f.zones[0].squareMetres, 3.0 * 2.4, 1e-6);
}

TEST(Figures, giveARoutesLengthStopsAndTime) {
  floor::Site site = goodFloor();
  site.routes = {{"r", {at(0, 0), at(10, 0), at(10, 5)}, Metres{0.2}}};
  const Figures f = figuresOf(site, MetresPerSecond{0.5});
  ASSERT_EQ(f.routes.size(), 1U);
  EXPECT_NEAR(f.routes[0].length.value(), 15.0, 1e-9);
  EXPECT_EQ(f.routes[0].stops, 2);
  // 15 m at 0.5 m/s; twice 0.5 s lost speeding up at 0.5 m/s² and 1 s braking; a quarter turn at 1.5 rad/s.
  EXPECT_NEAR(f.routes[0].time.value(), 30.0 + 2 * 1.5 + kPi / 2 / 1.5, 1e-9);
  EXPECT_GT(figuresOf(site, MetresPerSecond{0.25}).routes[0].time, f.routes[0].time);
  EXPECT_EQ(figuresOf(site, MetresPerSecond{9}).routes[0].time, f.routes[0].time) << "no faster than the vehicle";
}

TEST(Figures, reckonWithCornersThatAreRounded) {
  floor::Site site = goodFloor();
  site.routes = {{"r", {at(0, 0), at(10, 0), at(10, 5)}, Metres{0.2}}};
  const Figures onTheSpot = figuresOf(site, MetresPerSecond{0.12});
  site.vehicles[0].cornerCut = Metres{0.15};
  const Figures rounded = figuresOf(site, MetresPerSecond{0.12});
  EXPECT_EQ(rounded.routes[0].stops, 1) << "at its end";
  EXPECT_EQ(rounded.routes[0].length, onTheSpot.routes[0].length) << "as drawn";
  // At 0.12 m/s it need not slow down: the arc of 0.362 m is by 0.155 m shorter than the corner.
  const double radius = 0.15 / (std::sqrt(2.0) - 1);
  EXPECT_NEAR(rounded.routes[0].time.value(), 15 / 0.12 + 0.36 - radius * (2 - kPi / 2) / 0.12, 0.01);
  EXPECT_LT(rounded.routes[0].time, onTheSpot.routes[0].time - Seconds{2});
}

TEST(Figures, reckonWithTheSlowestZone) {
  floor::Site site = goodFloor();
  site.routes = {{"r", {at(0, 1), at(3, 1)}, Metres{0.2}}};
  const double before = figuresOf(site).routes[0].time.value();
  site.zones.push_back(sitecheck::zone("s", floor::ZoneKind::Slow, sitecheck::rectangle(1, 0, 2, 2)));
  site.zones.back().speed = MetresPerSecond{0.25};
  EXPECT_NEAR(figuresOf(site).routes[0].time.value(), before + 1 / 0.25 - 1 / 0.5, 1e-6);
  site.zones.push_back(sitecheck::zone("s", floor::ZoneKind::Slow, sitecheck::rectangle(1.5, 0, 2, 2)));
  site.zones.back().speed = MetresPerSecond{0.1};
  EXPECT_NEAR(figuresOf(site).routes[0].time.value(), before + 0.5 * (4 - 2) + 0.5 * (10 - 2), 1e-6);
}

TEST(Figures, reckonWithTheSpeedsOfLegs) {
  floor::Site site = goodFloor();
  site.routes = {{"r", {at(0, 1), at(1, 1), at(3, 1)}, Metres{0.2}}};
  const double before = figuresOf(site).routes[0].time.value();
  site.routes[0].legSpeeds = {MetresPerSecond{0.1}, std::nullopt};
  EXPECT_NEAR(figuresOf(site).routes[0].time.value(), before + 1 / 0.1 - 1 / 0.5, 1e-6);
  site.routes[0].legSpeeds = {MetresPerSecond{9}, std::nullopt};
  EXPECT_NEAR(figuresOf(site).routes[0].time.value(), before, 1e-6) << "no faster than the vehicle";
}

TEST(Figures, ofNothingAreNought) {
  const Figures f = figuresOf({});
  EXPECT_EQ(f.tilesLaid + f.tagPlaces + f.registered + f.zones.size() + f.routes.size(), 0U);
  EXPECT_EQ(f.floorSquareMetres, 0.0);
}

}  // namespace
}  // namespace tessera::sitediff
