#include "firmware/vehicle/drive_control.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firmware/vehicle/angles.h"

namespace tessera::firmware::test {
namespace {

float radians(float degrees) { return degrees * kPi / 180.0F; }

// A vehicle that does at once what is wanted.
struct IdealVehicle {
  DriveControl control;
  float nose = 0.0F;
  float overshoot = 0.0F;
  float slowest = 1.0F;
  Motion motion;

  IdealVehicle() { control.configure({}); }
  void hold(float speed, float bearing, int ticks) {
    const float side = wrapAngle(bearing - nose) < 0 ? -1.0F : 1.0F;
    for (int i = 0; i < ticks; ++i) {
      motion = control.hold(speed, bearing, nose);
      nose = wrapAngle(nose - motion.turnRate * 0.01F);
      overshoot = std::max(overshoot, side * wrapAngle(nose - bearing));
      slowest = std::min(slowest, motion.speed);
    }
  }
};

TEST(DriveControl, turnsBeforeItDrivesWhenTheBearingIsFarOff) {
  IdealVehicle v;
  v.hold(0.3F, radians(90), 20);
  EXPECT_TRUE(v.control.turning());
  EXPECT_EQ(v.motion.speed, 0.0F);
  EXPECT_LT(v.motion.turnRate, 0.0F) << "clockwise";
  v.hold(0.3F, radians(90), 400);
  EXPECT_FALSE(v.control.turning());
  EXPECT_NEAR(v.motion.speed, 0.3F, 0.001F);
  EXPECT_NEAR(v.nose, radians(90), radians(0.2F));
  EXPECT_LT(v.overshoot, radians(1));
}

TEST(DriveControl, takesTheShortWayRoundThroughSouth) {
  IdealVehicle v;
  v.nose = radians(170);
  v.hold(0.0F, radians(-170), 1);
  EXPECT_LT(v.motion.turnRate, 0.0F);
  v.hold(0.0F, radians(-170), 200);
  EXPECT_NEAR(wrapAngle(v.nose - radians(-170)), 0.0F, radians(1));
}

TEST(DriveControl, keepsToTheLimitsOfSpeedTurnRateAndAcceleration) {
  Settings s;
  IdealVehicle v;
  Motion before;
  for (int i = 0; i < 1000; ++i) {
    const int leg = i / 150;
    const float bearing = radians(static_cast<float>(leg) * 77.0F);
    v.hold(i % 300 < 150 ? 0.5F : -0.4F, bearing, 1);
    EXPECT_LE(std::fabs(v.motion.speed) + std::fabs(v.motion.turnRate) * 0.15F, 0.5F + 0.06F);
    EXPECT_LE(std::fabs(v.motion.turnRate), 1.5F + 1e-4F);
    EXPECT_LE(std::fabs(v.motion.speed - before.speed), 0.005F + 1e-5F);
    EXPECT_LE(std::fabs(v.motion.turnRate - before.turnRate), 0.0334F);
    before = v.motion;
  }
}

TEST(DriveControl, doesNotSlowDownForSmallCorrections) {
  IdealVehicle v;
  v.hold(0.2F, 0.0F, 200);
  v.slowest = 1.0F;
  v.hold(0.2F, radians(9), 200);
  EXPECT_GT(v.slowest, 0.199F);
}

TEST(DriveControl, drivesBackwardsWithTheNoseOnTheBearing) {
  IdealVehicle v;
  v.hold(-0.2F, radians(20), 300);
  EXPECT_NEAR(v.motion.speed, -0.2F, 0.001F);
  EXPECT_NEAR(v.nose, radians(20), radians(0.5F));
}

TEST(DriveControl, standsStillWhenAlignedAndNotForEveryBitOfNoise) {
  IdealVehicle v;
  v.hold(0.0F, radians(40), 300);
  EXPECT_TRUE(v.control.standing());
  EXPECT_FALSE(v.control.turning());
  v.hold(0.0F, radians(41.5F), 50);
  EXPECT_TRUE(v.control.standing());
}

TEST(DriveControl, stopsThreeTimesAsHardAsItDrives) {
  IdealVehicle v;
  v.hold(0.45F, 0.0F, 300);
  int ticks = 0;
  while (!v.control.standing() && ticks < 100) {
    v.control.stop();
    ++ticks;
  }
  EXPECT_NEAR(ticks, 30, 1);
}

}  // namespace
}  // namespace tessera::firmware::test
