// A patch leads from one site to another and back, and is as small as what changed.
#include "floor/site_patch.h"

#include <gtest/gtest.h>

#include <random>

#include "floor/new_floor.h"
#include "floor/random_site.h"

namespace tessera::floor {
namespace {

void expectBothWays(const Site& before, const Site& after, const char* what) {
  const SitePatch patch{before, after};
  Site site = before;
  patch.apply(site);
  EXPECT_EQ(site, after) << what;
  patch.revert(site);
  EXPECT_EQ(site, before) << what;
}

TEST(SitePatchProperty, leadsFromAnySiteToAnyOtherAndBack) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) expectBothWays(randomSite(seed), randomSite(seed + 1), "unrelated");
}

TEST(SitePatchProperty, leadsOverAnyMixtureOfChangesInOneList) {
  std::mt19937 random{11};
  const Site floor = layNewFloor({"Hall", usualTileTypes()[0], 5, 4, true}).value();
  for (int round = 0; round < 500; ++round) {
    Site after = floor;
    for (unsigned n = random() % 8; n-- > 0;) {
      const auto any = [&] { return after.tiles.begin() + static_cast<std::ptrdiff_t>(random() % after.tiles.size()); };
      switch (random() % 4) {
        case 0:
          any()->serial += "x";
          break;
        case 1:
          if (after.tiles.size() > 1) after.tiles.erase(any());
          break;
        case 2:
          after.tiles.insert(any(), {"new", "type", {}});
          break;
        default:
          std::iter_swap(any(), any());
      }
    }
    expectBothWays(floor, after, "mixture");
  }
}

class PatchOfALargeFloor : public testing::Test {
protected:
  [[nodiscard]] std::size_t items() const { return SitePatch{before, after}.items(); }
  Site before = layNewFloor({"Hall", usualTileTypes()[0], 50, 40, true}).value();
  Site after = before;
};

TEST_F(PatchOfALargeFloor, isEmptyWhereNothingChanged) { EXPECT_TRUE((SitePatch{before, after}.empty())); }

TEST_F(PatchOfALargeFloor, holdsWhatMovedInPlaceAndNothingElse) {
  for (const std::size_t n : {0U, 700U, 701U, 1999U}) after.placements[n].quarterTurns = 1;
  EXPECT_EQ(items(), 8U);
}

TEST_F(PatchOfALargeFloor, holdsWhatWasTakenOutAtDistantPlaces) {
  for (const std::ptrdiff_t n : {1999, 700, 3}) {
    after.placements.erase(after.placements.begin() + n);
    after.tiles.erase(after.tiles.begin() + n);
  }
  EXPECT_EQ(items(), 6U);
}

TEST_F(PatchOfALargeFloor, holdsWhatWasPutInAtDistantPlaces) {
  for (const std::ptrdiff_t n : {3, 700, 2002})
    after.tiles.insert(after.tiles.begin() + n, {std::to_string(n), "t", {}});
  EXPECT_EQ(items(), 3U);
}

TEST_F(PatchOfALargeFloor, tellsAChangedItemFromOneTakenOutElsewhere) {
  after.tiles[5].serial = "other";
  after.tiles.erase(after.tiles.begin() + 1500);
  EXPECT_EQ(items(), 3U);
}

TEST_F(PatchOfALargeFloor, holdsValuesThatStandOnce) {
  after.name = "Other hall";
  after.radio.channel = 4;
  EXPECT_EQ(items(), 4U);
}

}  // namespace
}  // namespace tessera::floor
