// Every fix that is offered mends the fault for which it is offered, and does nothing to another site.
#include <gtest/gtest.h>

#include <algorithm>

#include "floor/site_map.h"
#include "sitecheck/sites.h"

namespace tessera::sitecheck {
namespace {

using floor::Site;

std::size_t countLike(const Site& site, const Fault& like) {
  const Faults faults = faultsOf(site, like.kind);
  return static_cast<std::size_t>(
      std::count_if(faults.begin(), faults.end(), [&](const Fault& f) { return f.sentence == like.sentence; }));
}

TEST(Fix, mendsItsFaultInFloorsBrokenAtRandom) {
  std::size_t mended = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    std::mt19937_64 random{seed};
    Site site = goodFloor();
    for (int i = 0; i < 8; ++i) editAtRandom(site, random);
    for (const Fault& fault : checkSite(site).faults()) {
      if (!fault.fix) continue;
      Site after = site;
      ASSERT_TRUE(mend(fault.fix->edit, after)) << fault.sentence;
      ASSERT_NE(after, site) << fault.sentence;
      ASSERT_LT(countLike(after, fault), countLike(site, fault)) << seed << ": " << fault.fix->sentence;
      ++mended;
    }
  }
  EXPECT_GT(mended, 100U);
}

TEST(Fix, doesNothingToASiteThatIsNoLongerAsItWas) {
  Site site = goodFloor();
  for (const Edit& edit :
       {Edit{MoveTile{{"T-0001", at(5, 5), 0}, at(0, 0)}}, Edit{TakeTileUp{{"T-0001", at(5, 5), 0}}},
        Edit{ForgetTile{site.tiles[0]}}, Edit{RenameTile{site.tiles[0], "other"}}, Edit{DropUids{site.tiles[0], 900}},
        Edit{ForgetTileType{site.tileTypes[0]}}, Edit{ClearUid{"T-0001", 0, site.tiles[1].uids[0]}},
        Edit{ClearUid{"T-0001", 900, {}}}, Edit{ForgetLooseTag{}}, Edit{ReplaceOutline{"Floor", {}, {}}},
        Edit{ReplaceVertices{"round", {}, {}}}, Edit{SetLegSpeed{"round", 0, MetresPerSecond{1}, {}}},
        Edit{SetLegSpeed{"round", 9, {}, MetresPerSecond{1}}}, Edit{SetLegSpeeds{{}, {}}},
        Edit{MoveVertices{"round", {}, {}}}, Edit{ReverseRoute{}}, Edit{GiveAddress{{}, VehicleId{3}}}}) {
    EXPECT_FALSE(mend(edit, site)) << edit.index();
  }
  EXPECT_EQ(site, goodFloor());
}

TEST(Fix, makesAMapOfASiteOfWhichThereWasNone) {
  Site site = goodFloor();
  site.tileTypes.push_back(site.tileTypes[0]);
  site.tiles.push_back(site.tiles[0]);
  site.tiles.push_back({site.tiles[1].serial, site.tiles[1].type, {}});
  site.tiles[2].uids.resize(100);
  site.tiles[3].uids[0] = site.tiles[1].uids[0];
  site.placements.push_back({"unknown", at(20, 20), 0});
  site.placements.push_back({site.placements[4].serial, at(25, 20), 0});
  if (!site.vehicles.empty()) site.vehicles.push_back(site.vehicles[0]);
  ASSERT_FALSE(floor::SiteMap::build(site));
  // Each fix once, as a person goes through the list, which is new after each.
  for (int step = 0; step < 40; ++step) {
    const Faults faults = checkSite(site).faults();
    const auto next = std::find_if(faults.begin(), faults.end(),
                                   [](const Fault& f) { return f.severity == Severity::Error && f.fix; });
    if (next == faults.end()) break;
    ASSERT_TRUE(mend(next->fix->edit, site)) << next->sentence;
  }
  const auto map = floor::SiteMap::build(site);
  EXPECT_TRUE(map) << map.error().sentence;
  EXPECT_EQ(std::count_if(site.tiles.begin(), site.tiles.end(), [](const auto& t) { return t.serial == "T-0002-2"; }),
            1)
      << "of two that differ none is lost";
}

}  // namespace
}  // namespace tessera::sitecheck
