#include <gtest/gtest.h>

#include "floor/site.h"

namespace tessera::floor {
namespace {

TileType lattice(int columns, int rows, Pattern pattern) {
  const Metres pitch{0.15};
  return {"t", columns * pitch, rows * pitch, pitch, {pitch / 2, pitch / 2}, columns, rows, pattern, false, {}};
}

TEST(TileType, aFullOneHasATagAtEveryPlaceRowByRow) {
  const auto offsets = tagOffsets(lattice(3, 2, Pattern::Full));
  ASSERT_EQ(offsets.size(), 6U);
  EXPECT_EQ(offsets[0], (Offset{Metres{0.075}, Metres{0.075}}));
  EXPECT_DOUBLE_EQ(offsets[2].x.value(), 0.375);
  EXPECT_DOUBLE_EQ(offsets[3].y.value(), 0.225);
  EXPECT_DOUBLE_EQ(offsets[3].x.value(), 0.075);
}

TEST(TileType, oneInTwoStartsWithATagUnlessItSaysOtherwise) {
  TileType type = lattice(3, 3, Pattern::OneInTwo);
  EXPECT_EQ(tagOffsets(type).size(), 5U) << "nine places, five of even sum";
  EXPECT_EQ(tagOffsets(type).front(), type.margin);
  type.startsWithGap = true;
  EXPECT_EQ(tagOffsets(type).size(), 4U);
  EXPECT_DOUBLE_EQ(tagOffsets(type).front().x.value(), 0.225);
}

TEST(TileType, thePublicationsTileHasEightTags) { EXPECT_EQ(tagOffsets(lattice(4, 4, Pattern::OneInTwo)).size(), 8U); }

TEST(TileType, aCustomOneFollowsItsDrawingAndSurvivesAShortOne) {
  TileType type = lattice(2, 2, Pattern::Custom);
  type.custom = {false, true, true, false};
  const auto offsets = tagOffsets(type);
  ASSERT_EQ(offsets.size(), 2U);
  EXPECT_DOUBLE_EQ(offsets[0].x.value(), 0.225);
  EXPECT_DOUBLE_EQ(offsets[1].y.value(), 0.225);
  type.custom.clear();
  EXPECT_TRUE(tagOffsets(type).empty());
}

}  // namespace
}  // namespace tessera::floor
