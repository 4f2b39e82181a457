#include "firmware/vehicle/bend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "firmware/vehicle/angles.h"
#include "firmware/vehicle/heading.h"

namespace tessera::firmware::test {
namespace {

constexpr float kTrack = 0.3F;
constexpr float kLength = 10.0F;
constexpr float kSamplePeriod = 0.02F;

float inDegrees(float radians) { return radians * 180.0F / kPi; }
float turnOf(float angle) { return angle * kPi / 180.0F; }

// A vehicle that goes straight on over the floor, northwards, while its wheels tell a bend; over iron that turns the
// compass.
struct Drive {
  float bend = 0.0F;  // rad/m counter-clockwise that the wheels do not tell
  float noise = turnOf(0.6F);
  std::function<float(float)> iron = [](float) { return 0.0F; };  // degrees at a place on the way, clockwise
  Heading heading;
  Bend learner;
  std::mt19937 random{7};
  float place = 0.0F;
  float most = 0.0F;     // rad/m learned, the largest on the way
  float trusted = 0.0F;  // rad/m believed, the largest on the way

  Drive() {
    heading.configure(0.03F);
    learner.configure(kLength, kTrack);
    for (int i = 0; i < 100; ++i) heading.compass(0.0F);
  }
  void go(float metres, float speed) {
    std::normal_distribution<float> chance{0.0F, noise};
    const float way = speed * kSamplePeriod;
    for (const float end = place + std::fabs(metres); place < end; place += std::fabs(way)) {
      heading.turn(-bend * way + learner.perMetre() * way);
      learner.learn(way, heading.compass(turnOf(iron(place)) + chance(random)));
      most = std::max(most, std::fabs(learner.learned()));
      trusted = std::max(trusted, std::fabs(learner.perMetre()));
    }
  }
};

// Gaussian as in the simulated world.
std::function<float(float)> patch(float centre, float radius, float peak) {
  return [=](float place) { return peak * std::exp(-0.5F * std::pow((place - centre) / radius, 2.0F)); };
}

TEST(Bend, isLearnedAlongTheWayAtAnySpeed) {
  for (const float speed : {0.05F, 0.12F, 0.5F, -0.2F}) {
    for (const float bend : {0.33F, -0.1F}) {
      Drive drive;
      drive.bend = bend;
      drive.go(kLength, speed);
      EXPECT_NEAR(drive.learner.learned() / bend, 0.63F, 0.12F) << bend << " rad/m at " << speed << " m/s";
      drive.go(4.0F * kLength, speed);
      EXPECT_NEAR(drive.learner.perMetre() / bend, 1.0F, 0.05F) << bend << " rad/m at " << speed << " m/s";
    }
  }
}

TEST(Bend, takesAwayTheErrorOfTheBearing) {
  Drive drive;
  drive.bend = 0.33F;
  drive.go(1.0F, 0.5F);
  EXPECT_GT(std::fabs(inDegrees(drive.heading.bearing())), 4.0F);
  drive.go(5.0F * kLength, 0.5F);
  EXPECT_LT(std::fabs(inDegrees(drive.heading.bearing())), 0.5F);
}

TEST(Bend, isNotSeenInIron) {
  for (const float peak : {10.0F, 18.0F}) {
    for (const float speed : {0.05F, 0.12F, 0.5F}) {
      for (const float radius : {0.1F, 0.3F, 1.0F}) {
        Drive drive;
        drive.iron = patch(5.0F, radius, peak);
        drive.go(10.0F, speed);
        EXPECT_LT(drive.most, turnOf(peak) / kLength) << radius << " m at " << speed << " m/s";
        EXPECT_EQ(drive.trusted, 0.0F) << radius << " m at " << speed << " m/s";
        EXPECT_LT(std::fabs(drive.learner.learned()), 0.2F * turnOf(peak) / kLength) << "behind it";
      }
    }
  }
}

TEST(Bend, isNotLostOverIron) {
  Drive drive;
  drive.bend = 0.1F;
  drive.go(5.0F * kLength, 0.5F);
  const float before = drive.learner.perMetre();
  drive.iron = patch(drive.place + 3.0F, 0.3F, 10.0F);
  for (int i = 0; i < 60; ++i) {
    drive.go(0.1F, 0.5F);
    EXPECT_NEAR(drive.learner.perMetre(), before, 2.0F * turnOf(10.0F) / kLength);
  }
  EXPECT_NEAR(drive.learner.perMetre(), before, 0.01F);
}

TEST(Bend, isNeverMoreThanTyresMake) {
  Drive drive;
  drive.bend = 2.0F;
  drive.go(20.0F * kLength, 0.1F);
  EXPECT_FLOAT_EQ(drive.learner.perMetre(), 0.15F / kTrack);
}

TEST(Bend, isNotLearnedFromAPushOrWhileStanding) {
  Drive drive;
  drive.noise = 0.0F;
  drive.go(1.0F, 0.2F);
  for (int i = 0; i < 500; ++i) drive.learner.learn(0.0F, drive.heading.compass(turnOf(40)));
  drive.iron = [](float) { return 40.0F; };
  drive.go(5.0F, 0.2F);
  EXPECT_LT(drive.most, 0.15F / kTrack * 0.1F / kLength * 1.05F) << "one stretch's worth";
}

TEST(Bend, isForgottenWhenLearningIsSwitchedOff) {
  Drive drive;
  drive.bend = 0.2F;
  drive.go(20.0F, 0.5F);
  drive.learner.configure(kLength, kTrack);
  EXPECT_GT(drive.learner.perMetre(), 0.1F) << "another setting has changed, the tyres have not";
  drive.learner.configure(0.0F, kTrack);
  EXPECT_EQ(drive.learner.perMetre(), 0.0F);
  drive.go(20.0F, 0.5F);
  EXPECT_EQ(drive.learner.perMetre(), 0.0F);
}

}  // namespace
}  // namespace tessera::firmware::test
