#include "floor/seam.h"

#include <gtest/gtest.h>

#include "floor/new_floor.h"

namespace tessera::floor {
namespace {

TileType tile(Pattern pattern, int places, double side, double pitch, double margin) {
  return {"t",    Metres{side}, Metres{side}, Metres{pitch}, {Metres{margin}, Metres{margin}},
          places, places,       pattern,      false,         {}};
}

TEST(Seam, isEvenWhereMarginsAreHalfAPitch) {
  for (const TileType& type : usualTileTypes()) {
    for (const Side side : {Side::Right, Side::Above}) {
      const Seam seam = seamOf(type, side);
      EXPECT_EQ(seam.fit, Seam::Fit::Even) << type.name;
      EXPECT_NEAR(seam.pitch.value(), type.pitch.value(), 1e-9) << type.name;
    }
  }
}

TEST(Seam, isCloserOrWiderWhereTheyAreNot) {
  EXPECT_EQ(seamOf(tile(Pattern::Full, 3, 0.4, 0.15, 0.05), Side::Right).fit, Seam::Fit::Closer);
  EXPECT_NEAR(seamOf(tile(Pattern::Full, 3, 0.4, 0.15, 0.05), Side::Right).pitch.value(), 0.1, 1e-9);
  EXPECT_EQ(seamOf(tile(Pattern::Full, 3, 0.5, 0.15, 0.1), Side::Above).fit, Seam::Fit::Wider);
}

TEST(Seam, tellsWhereTwoTagsMeet) {
  EXPECT_TRUE(seamOf(tile(Pattern::OneInTwo, 4, 0.6, 0.15, 0.075), Side::Right).meeting.empty());
  // Three places: the last of a row has a tag, and so has the first of the next tile.
  const Seam odd = seamOf(tile(Pattern::OneInTwo, 3, 0.45, 0.15, 0.075), Side::Right);
  ASSERT_EQ(odd.meeting.size(), 2U);
  EXPECT_NEAR(odd.apart.value(), 0.15, 1e-9);
  EXPECT_NEAR(odd.meeting[0].first.x.value(), 0.375, 1e-9);
  EXPECT_NEAR(odd.meeting[0].second.x.value(), 0.525, 1e-9);
  EXPECT_NEAR(odd.meeting[0].second.y.value(), odd.meeting[0].first.y.value(), 1e-9);
  const Seam closer = seamOf(tile(Pattern::Full, 3, 0.4, 0.15, 0.05), Side::Above);
  EXPECT_EQ(closer.meeting.size(), 3U);
  EXPECT_NEAR(closer.apart.value(), 0.1, 1e-9);
}

TEST(Seam, knowsTheClosestTagsOfATile) {
  EXPECT_NEAR(closestTags(tile(Pattern::Full, 4, 0.6, 0.15, 0.075))->value(), 0.15, 1e-9);
  EXPECT_NEAR(closestTags(tile(Pattern::OneInTwo, 4, 0.6, 0.15, 0.075))->value(), 0.15 * std::sqrt(2.0), 1e-9);
  TileType one = tile(Pattern::Custom, 2, 0.3, 0.15, 0.075);
  one.custom = {false, true, false, false};
  EXPECT_FALSE(closestTags(one));
  EXPECT_TRUE(seamOf(one, Side::Right).meeting.empty());
}

TEST(Seam, isFoundOnTheLargestTileWithoutDelay) {
  const TileType large = tile(Pattern::Full, 100, 9.95, 0.1, 0.0);
  EXPECT_EQ(seamOf(large, Side::Right).meeting.size(), 100U);
}

}  // namespace
}  // namespace tessera::floor
