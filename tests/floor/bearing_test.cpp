#include "floor/bearing.h"

#include <gtest/gtest.h>

#include <random>

namespace tessera::floor {
namespace {

TEST(Bearing, ofAVehicleThatFacesAlongYIsNorthToY) {
  for (double north : {0.0, 20.0, -35.0, 179.0}) {
    EXPECT_NEAR(degrees(bearingOfHeading(fromDegrees(90), fromDegrees(north))), north, 1e-9);
    EXPECT_NEAR(degrees(headingOfBearing(fromDegrees(north), fromDegrees(north))), 90.0, 1e-9);
  }
}

TEST(Bearing, turnsClockwiseWhereTheHeadingTurnsCounterClockwise) {
  const Radians north = fromDegrees(20);
  EXPECT_NEAR(degrees(headingOfBearing(fromDegrees(20 + 90), north)), 0.0, 1e-9) << "right of +y is +x";
  EXPECT_NEAR(degrees(headingOfBearing(fromDegrees(20 - 90), north)), 180.0, 1e-9);
}

TEST(Bearing, goesThereAndBack) {
  std::mt19937_64 random{3};
  std::uniform_real_distribution<double> angle{-kPi, kPi};
  for (int i = 0; i < 10'000; ++i) {
    const Radians heading{angle(random)};
    const Radians north{angle(random)};
    const Radians back = headingOfBearing(bearingOfHeading(heading, north), north);
    ASSERT_NEAR(turnBetween(heading, back).value(), 0.0, 1e-12);
  }
}

TEST(Bearing, everyBinaryAngleSurvives) {
  for (std::uint32_t b = 0; b < 65536; ++b) {
    ASSERT_EQ(toBinaryAngle(fromBinaryAngle(static_cast<std::uint16_t>(b))), b);
  }
  EXPECT_EQ(toBinaryAngle(Radians{kPi / 2}), 0x4000);
  EXPECT_EQ(toBinaryAngle(Radians{-kPi / 2}), 0xC000);
  EXPECT_EQ(toBinaryAngle(Radians{2 * kPi - 1e-9}), 0);
}

}  // namespace
}  // namespace tessera::floor
