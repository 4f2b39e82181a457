// Every fix that is offered mends the fault for which it is offered, and does nothing to another site.
#include <gtest/gtest.h>

#include <algorithm>

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
        Edit{ForgetTile{site.tiles[0]}}, Edit{ClearUid{"T-0001", 0, site.tiles[1].uids[0]}},
        Edit{ClearUid{"T-0001", 900, {}}}, Edit{ForgetLooseTag{}}, Edit{ReplaceOutline{"Floor", {}, {}}},
        Edit{ReplaceVertices{"round", {}, {}}}, Edit{SetLegSpeed{"round", 0, MetresPerSecond{1}, {}}},
        Edit{SetLegSpeed{"round", 9, {}, MetresPerSecond{1}}}, Edit{SetLegSpeeds{{}, {}}},
        Edit{MoveVertices{"round", {}, {}}}, Edit{ReverseRoute{}}, Edit{GiveAddress{{}, VehicleId{3}}}}) {
    EXPECT_FALSE(mend(edit, site)) << edit.index();
  }
  EXPECT_EQ(site, goodFloor());
}

}  // namespace
}  // namespace tessera::sitecheck
