#include "sitediff/tally.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "floor/random_site.h"
#include "sitecheck/sites.h"
#include "sitediff/difference.h"

namespace tessera::sitediff {
namespace {

using floor::Site;
using sitecheck::goodFloor;

template <class Edit>
Tally after(Edit edit) {
  Site site = goodFloor();
  edit(site);
  return tallyOf(goodFloor(), site);
}

TEST(Tally, isEmptyForOneSiteInAnyOrder) {
  EXPECT_TRUE(after([](Site&) {}).empty());
  EXPECT_TRUE(after([](Site& s) { std::reverse(s.placements.begin(), s.placements.end()); }).empty());
}

TEST(Tally, tellsTilesLaidMovedAndTakenUpApart) {
  EXPECT_EQ(after([](Site& s) { s.placements.pop_back(); }), (Tally{.takenUp = 1}));
  EXPECT_EQ(after([](Site& s) { s.placements[0].origin.x = Metres{77.0}; }), (Tally{.moved = 1}));
  EXPECT_EQ(after([](Site& s) { s.placements[0].quarterTurns ^= 1; }), (Tally{.moved = 1}));
  Site bare = goodFloor();
  bare.placements.pop_back();
  EXPECT_EQ(tallyOf(bare, goodFloor()), (Tally{.laid = 1}));
}

TEST(Tally, countsEachTagThatIsAnother) {
  EXPECT_EQ(after([](Site& s) { s.tiles[0].uids.at(0) = {}; }).tags, 1);
  EXPECT_EQ(after([](Site& s) { std::swap(s.tiles[0].uids.at(0), s.tiles[0].uids.at(1)); }).tags, 2);
}

TEST(Tally, countsZonesRoutesAndVehiclesThatAreNewGoneOrOthers) {
  EXPECT_EQ(after([](Site& s) { s.routes.push_back({"new", {}, Metres{0.2}}); }), (Tally{.routes = 1}));
  EXPECT_EQ(after([](Site& s) { s.routes.at(0).controlSpacing = Metres{0.3}; }), (Tally{.routes = 1}));
  EXPECT_EQ(after([](Site& s) { s.zones.push_back({"new", {}, {}, {}, {}}); }), (Tally{.zones = 1}));
  EXPECT_EQ(after([](Site& s) { s.vehicles.emplace_back().id = VehicleId{77}; }), (Tally{.vehicles = 1}));
  EXPECT_EQ(after([](Site& s) { s.name += "!"; }), (Tally{.others = 1}));
}

TEST(Tally, isEmptyJustWhereTheListOfDifferencesIs) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Site a = floor::randomSite(seed);
    const Site b = floor::randomSite(seed + seed % 2);
    EXPECT_EQ(tallyOf(a, b).empty(), difference(a, b).empty()) << seed;
  }
}

}  // namespace
}  // namespace tessera::sitediff
