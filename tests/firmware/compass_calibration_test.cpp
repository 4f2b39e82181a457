#include "firmware/vehicle/compass_calibration.h"

#include <gtest/gtest.h>

#include <random>

#include "firmware/vehicle/angles.h"

namespace tessera::firmware::test {
namespace {

using Status = CompassCalibration::Status;

// A vehicle that turns as it is told, in a field bent by its own iron: measured = iron * field + offset + noise.
struct Turntable {
  CompassCalibration calibration;
  std::array<double, 3> iron{1.0, 0.0, 1.0};  ///< xx, xy = yx, yy
  std::array<double, 2> offset{60.0, 60.0};
  double noise = 0.2;
  double strength = 20.0;
  double slip = 0.0;
  double bearing = 1.0;
  std::mt19937 random{7};

  Field measure(double at) {
    std::normal_distribution<double> n{0.0, noise};
    const double x = strength * std::cos(at);
    const double y = strength * std::sin(at);
    return {static_cast<float>(iron[0] * x + iron[1] * y + offset[0] + n(random)),
            static_cast<float>(iron[1] * x + iron[2] * y + offset[1] + n(random))};
  }
  Status run(double seconds = 100.0) {
    Micros now{0};
    calibration.start(now);
    for (int tick = 0; tick < seconds * 100; ++tick) {
      now += 10ms;
      const double turned = calibration.turnRate() * 0.01;
      bearing -= turned * (1.0 - slip);
      const auto field = tick % 2 == 0 ? std::optional{measure(bearing)} : std::nullopt;
      if (calibration.tick(static_cast<float>(turned), field, now) != Status::Turning) break;
    }
    return calibration.status();
  }
  double worstErrorDegrees() {
    noise = 0.0;
    double worst = 0.0;
    for (int i = 0; i < 360; ++i) {
      const double at = i * 3.14159265 / 180.0;
      const Field c = calibration.correction().apply(measure(at));
      worst = std::max(worst, std::fabs(static_cast<double>(wrapAngle(std::atan2(c.y, c.x) - static_cast<float>(at)))));
    }
    return worst * 180.0 / 3.14159265;
  }
};

TEST(CompassCalibration, removesHardIron) {
  Turntable table;
  ASSERT_EQ(table.run(), Status::Done);
  EXPECT_NEAR(table.calibration.correction().offsetX, 60.0, 0.2);
  EXPECT_LT(table.worstErrorDegrees(), 0.5);
}

TEST(CompassCalibration, leavesLessThanADegreeWithStrongSoftIronAndNoise) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Turntable table;
    table.random.seed(seed);
    table.iron = {1.6, 0.4, 0.8};
    table.offset = {75.0, -48.0};
    table.noise = 0.4;
    ASSERT_EQ(table.run(), Status::Done) << seed;
    EXPECT_LT(table.worstErrorDegrees(), 1.0) << seed;
  }
}

TEST(CompassCalibration, bearsWheelsThatSlip) {
  Turntable table;
  table.iron = {1.2, 0.1, 0.9};
  table.slip = 0.03;
  ASSERT_EQ(table.run(), Status::Done);
  EXPECT_LT(table.worstErrorDegrees(), 1.0);
}

TEST(CompassCalibration, endsWhereItBegan) {
  Turntable table;
  ASSERT_EQ(table.run(), Status::Done);
  EXPECT_NEAR(table.bearing, 1.0, 0.02);
  EXPECT_EQ(table.calibration.turnRate(), 0.0F);
}

TEST(CompassCalibration, failsWhenTheVehicleDoesNotTurn) {
  Turntable table;
  table.slip = 1.0;
  EXPECT_EQ(table.run(), Status::Failed);
}

TEST(CompassCalibration, failsInAFieldThatIsNotTheEarths) {
  Turntable table;
  table.strength = 3.0;
  EXPECT_EQ(table.run(), Status::Failed);
  table.strength = 100.0;
  EXPECT_EQ(table.run(), Status::Failed);
}

TEST(CompassCalibration, failsWhenTheFieldChangesMeanwhile) {
  Turntable table;
  table.noise = 6.0;
  table.strength = 12.0;
  EXPECT_EQ(table.run(), Status::Failed);
}

TEST(CompassCalibration, failsWithoutSamplesAndAfterAMinute) {
  CompassCalibration calibration;
  calibration.start(Micros{0});
  EXPECT_EQ(calibration.tick(0.0F, std::nullopt, Micros{59s}), Status::Turning);
  EXPECT_EQ(calibration.tick(0.0F, std::nullopt, Micros{61s}), Status::Failed);
  calibration.start(Micros{0});
  for (int i = 0; i < 2000; ++i) calibration.tick(calibration.turnRate() * 0.01F, std::nullopt, Micros{1s});
  EXPECT_EQ(calibration.status(), Status::Failed);
}

TEST(EllipseFit, refusesSamplesThatLieOnNoEllipse) {
  std::vector<Field> line;
  for (int i = 0; i < 40; ++i) line.push_back({static_cast<float>(i), static_cast<float>(2 * i)});
  EXPECT_FALSE(fitEllipse(line));
  const std::vector<Field> point(40, Field{3.0F, 4.0F});
  EXPECT_FALSE(fitEllipse(point));
  EXPECT_FALSE(fitEllipse(std::span{line}.first(4)));
}

}  // namespace
}  // namespace tessera::firmware::test
