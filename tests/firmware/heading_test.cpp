#include "firmware/vehicle/heading.h"

#include <gtest/gtest.h>

#include <random>

#include "firmware/vehicle/angles.h"

namespace tessera::firmware::test {
namespace {

float degrees(float radians) { return radians * 180.0F / kPi; }
float bearingAt(float inDegrees) { return inDegrees * kPi / 180.0F; }

TEST(Heading, takesTheFirstSampleAndFollowsTheWheels) {
  Heading heading;
  EXPECT_FALSE(heading.known());
  heading.compass(bearingAt(90));
  EXPECT_TRUE(heading.known());
  heading.turn(bearingAt(30));  // counter-clockwise: the bearing falls
  EXPECT_NEAR(degrees(heading.bearing()), 60.0F, 0.01F);
}

TEST(Heading, filtersTheCompassNoise) {
  Heading heading;
  heading.configure(0.01F);
  std::mt19937 random{3};
  std::normal_distribution<float> noise{0.0F, bearingAt(2)};
  double squares = 0.0;
  for (int i = 0; i < 5000; ++i) {
    heading.compass(bearingAt(45) + noise(random));
    if (i >= 1000) squares += std::pow(degrees(heading.bearing()) - 45.0, 2);
  }
  EXPECT_LT(std::sqrt(squares / 4000), 0.3);
}

TEST(Heading, pullsTheDriftOfTheWheelsIn) {
  Heading heading;
  heading.configure(0.01F);
  for (int i = 0; i < 3000; ++i) {
    heading.turn(bearingAt(0.01F));  // 0.5 degrees a second at 50 Hz
    heading.compass(0.0F);
  }
  EXPECT_LT(std::fabs(degrees(heading.bearing())), 1.1F);
}

TEST(Heading, wrapsWithoutAJump) {
  Heading heading;
  heading.configure(0.05F);
  heading.compass(bearingAt(179));
  for (int i = 0; i < 400; ++i) heading.compass(bearingAt(-179));
  EXPECT_NEAR(std::fabs(degrees(heading.bearing())), 179.0F, 0.3F);
  heading.turn(bearingAt(10));
  heading.turn(bearingAt(-10));
  EXPECT_GT(std::fabs(degrees(heading.bearing())), 178.0F);
}

TEST(Heading, ignoresSpikes) {
  Heading heading;
  heading.configure(0.01F);
  for (int i = 0; i < 500; ++i) heading.compass(i % 10 == 9 ? bearingAt(170) : bearingAt(10));
  EXPECT_NEAR(degrees(heading.bearing()), 10.0F, 0.1F);
}

TEST(Heading, limitsWhatADisturbedFloorCanDo) {
  Heading heading;
  heading.configure(0.01F);
  for (int i = 0; i < 200; ++i) heading.compass(0.0F);
  for (int i = 0; i < 25; ++i) heading.compass(bearingAt(40));  // half a second: 0.25 · 20 degrees
  EXPECT_LT(degrees(heading.bearing()), 5.1F);
}

TEST(Heading, believesACompassThatInsists) {
  Heading heading;
  heading.configure(0.01F);
  for (int i = 0; i < 200; ++i) heading.compass(0.0F);
  for (int i = 0; i < 49; ++i) heading.compass(bearingAt(120));
  EXPECT_NEAR(heading.bearing(), 0.0F, 0.01F);
  for (int i = 0; i < 5; ++i) heading.compass(bearingAt(120));
  EXPECT_NEAR(degrees(heading.bearing()), 120.0F, 0.1F);
}

}  // namespace
}  // namespace tessera::firmware::test
