#include "base/angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tessera {
namespace {

TEST(Angle, wrapsIntoTheHalfOpenCircle) {
  EXPECT_EQ(wrapped(Radians{0.0}).value(), 0.0);
  EXPECT_EQ(wrapped(Radians{kPi}).value(), kPi);
  EXPECT_EQ(wrapped(Radians{-kPi}).value(), kPi) << "minus half a turn is half a turn";
  EXPECT_NEAR(wrapped(Radians{1.5 * kPi}).value(), -0.5 * kPi, 1e-15);
  EXPECT_NEAR(wrapped(Radians{-1.5 * kPi}).value(), 0.5 * kPi, 1e-15);
  EXPECT_EQ(wrapped(Radians{std::nextafter(-kPi, 0.0)}).value(), std::nextafter(-kPi, 0.0));
}

TEST(Angle, wrappingKeepsTheDirection) {
  std::mt19937_64 random{1};
  std::uniform_real_distribution<double> any{-1000.0, 1000.0};
  for (int i = 0; i < 100'000; ++i) {
    const Radians a{any(random)};
    const Radians w = wrapped(a);
    ASSERT_GT(w.value(), -kPi);
    ASSERT_LE(w.value(), kPi);
    ASSERT_NEAR(cos(a), cos(w), 1e-9);
    ASSERT_NEAR(sin(a), sin(w), 1e-9);
    ASSERT_EQ(wrapped(w), w);
  }
}

TEST(Angle, everyMultipleOfHalfATurnStaysInTheRange) {
  for (int k = -1000; k <= 1000; ++k) {
    for (double at : {k * kPi, std::nextafter(k * kPi, -1e9), std::nextafter(k * kPi, 1e9)}) {
      const double w = wrapped(Radians{at}).value();
      ASSERT_GT(w, -kPi) << k;
      ASSERT_LE(w, kPi) << k;
    }
  }
}

TEST(Angle, shortestTurnGoesAcrossTheSeam) {
  EXPECT_NEAR(degrees(turnBetween(fromDegrees(170), fromDegrees(-170))), 20.0, 1e-12);
  EXPECT_NEAR(degrees(turnBetween(fromDegrees(-170), fromDegrees(170))), -20.0, 1e-12);
  EXPECT_NEAR(degrees(turnBetween(fromDegrees(10), fromDegrees(-10))), -20.0, 1e-12);
  EXPECT_EQ(turnBetween(Radians{0}, Radians{-kPi}).value(), kPi);
}

TEST(Angle, degreesAndBack) {
  EXPECT_DOUBLE_EQ(degrees(Radians{kPi}), 180.0);
  EXPECT_DOUBLE_EQ(fromDegrees(90).value(), kPi / 2);
}

}  // namespace
}  // namespace tessera
