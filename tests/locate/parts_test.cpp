// The locators' parts: the disc as evidence, and the odometry's history.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "base/angle.h"
#include "locate/disc_model.h"
#include "locate/odometry.h"

namespace tessera::locate {
namespace {

PlaneBelief around(double x, double y, double sigma) { return {{x, y}, sigma * sigma * Eigen::Matrix2d::Identity()}; }

SilentAttempts cameFrom(double x, double y) {
  SilentAttempts silent;
  silent.offset[0] = {x, y};
  silent.offset[1] = {2 * x, 2 * y};
  silent.count = 2;
  return silent;
}

TEST(DiscModel, aReadAloneSaysInsideTheDisc) {
  const DiscUpdate u = updateByDisc({}, around(0.0, 0.0, 1.0), {0.3, 0.2}, {});
  EXPECT_NEAR(u.belief.mean.x(), 0.3, 1e-3);
  EXPECT_NEAR(u.belief.mean.y(), 0.2, 1e-3);
  EXPECT_NEAR(std::sqrt(u.belief.covariance(0, 0)), 0.03, 0.002) << "a uniform disc has r/2 per axis";
}

TEST(DiscModel, aFirstReadSaysThatTheTagCameOverTheFrontRim) {
  const DiscUpdate u = updateByDisc({}, around(0.0, 0.0, 0.05), {0.0, 0.0}, cameFrom(-0.012, 0.0));
  EXPECT_LT(u.belief.mean.x(), -0.02) << "the reader is still behind the tag";
  EXPECT_NEAR(u.belief.mean.y(), 0.0, 1e-3);
  DiscModel sure;
  sure.detection = 0.99;
  sure.outlier = 0.0;
  const DiscUpdate rim = updateByDisc(sure, around(0.0, 0.0, 0.05), {0.0, 0.0}, cameFrom(-0.012, 0.0));
  const DiscUpdate plain = updateByDisc(sure, around(0.0, 0.0, 0.05), {0.0, 0.0}, {});
  EXPECT_LT(std::sqrt(rim.belief.covariance(0, 0)), 0.75 * std::sqrt(plain.belief.covariance(0, 0)));
}

TEST(DiscModel, aTagFarAwayIsNoEvidence) {
  const PlaneBelief before = around(0.0, 0.0, 0.01);
  const DiscUpdate u = updateByDisc({}, before, {0.2, 0.0}, {});
  EXPECT_LT(u.evidence, 1e-6);
  EXPECT_EQ(u.belief.mean, before.mean);
  EXPECT_EQ(u.belief.covariance, before.covariance);
}

TEST(DiscModel, aSureBeliefIsHardlyMovedAndStaysPositiveDefinite) {
  const DiscUpdate u = updateByDisc({}, around(0.01, 0.0, 0.0005), {0.0, 0.0}, {});
  EXPECT_NEAR(u.evidence, 1.0, 0.02);
  EXPECT_NEAR(u.belief.mean.x(), 0.01, 1e-4);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(u.belief.covariance).eigenvalues().minCoeff(), 0.0);
}

TEST(DiscModel, survivesABeliefThatIsNone) {
  PlaneBelief flat = around(0.0, 0.0, 1.0);
  flat.covariance.setZero();
  EXPECT_EQ(updateByDisc({}, flat, {0.0, 0.0}, {}).evidence, 0.0);
  flat.covariance.setConstant(std::nan(""));
  EXPECT_EQ(updateByDisc({}, flat, {0.0, 0.0}, {}).evidence, 0.0);
}

Motion motion(double at, double travel, double heading = 0.0, double speed = 0.1) {
  return {Seconds{at}, Metres{travel}, MetresPerSecond{speed}, Radians{heading}};
}

TEST(Odometry, interpolatesAndRollsOnForABoundedTime) {
  Odometry odometry{MetresPerSecond{0.5}};
  odometry.add(motion(0.0, 0.0));
  odometry.add(motion(2.0, 0.2));
  EXPECT_NEAR(odometry.at(0.5).travel, 0.05, 1e-12);
  EXPECT_NEAR(odometry.at(2.5).travel, 0.25, 1e-12);
  EXPECT_NEAR(odometry.at(99.0).travel, 0.30, 1e-12) << "one second at most";
  EXPECT_NEAR(odometry.at(-1.0).travel, 0.0, 1e-12);
}

TEST(Odometry, knowsFromTheSpeedsHowTheWayBetweenTwoSamplesWasDriven) {
  // Brakes with 0.5 m/s², from 0.2 m/s to a stand: 0.4 s, 4 cm.
  Odometry odometry{MetresPerSecond{0.5}};
  odometry.add(motion(0.0, 1.0, 0.0, 0.2));
  odometry.add(motion(0.4, 1.04, 0.0, 0.0));
  for (const double t : {0.1, 0.2, 0.3}) EXPECT_NEAR(odometry.at(t).travel, 1.0 + 0.2 * t - 0.25 * t * t, 1e-9);
  // Speeds that contradict the way do not lead beyond it.
  odometry.add(motion(0.8, 1.041, 0.0, 0.5));
  for (double t = 0.4; t < 0.8; t += 0.01) {
    EXPECT_GE(odometry.at(t + 0.01).travel, odometry.at(t).travel - 1e-12);
    EXPECT_LE(odometry.at(t).travel, 1.041 + 1e-12);
  }
}

TEST(Odometry, takesTheShortWayRoundTheCircle) {
  Odometry odometry{MetresPerSecond{0.5}};
  odometry.add(motion(0.0, 0.0, 3.1));
  odometry.add(motion(1.0, 0.0, -3.1));
  EXPECT_NEAR(wrapped(Radians{odometry.at(0.5).heading}).value(), kPi, 1e-9);
  odometry.add(motion(0.5, 0.0, -3.12));
  EXPECT_NEAR(odometry.at(1.0).heading, 2 * kPi - 3.1, 1e-9) << "a late sample does not unwind what comes after it";
}

TEST(Odometry, takesARestartedOdometerForAStandstill) {
  Odometry odometry{MetresPerSecond{0.5}};
  odometry.add(motion(0.0, 123.0));
  odometry.add(motion(0.2, 0.0));
  odometry.add(motion(0.4, 0.02));
  EXPECT_NEAR(odometry.at(0.4).travel, 123.02, 1e-9);
}

TEST(Odometry, walksSampleBySample) {
  Odometry odometry{MetresPerSecond{0.5}};
  for (int i = 0; i <= 4; ++i) odometry.add(motion(i, 0.1 * i));
  int steps = 0;
  double way = 0.0;
  odometry.walk(0.5, 3.25, [&](const Odometry::Sample& a, const Odometry::Sample& b) {
    ++steps;
    way += b.travel - a.travel;
  });
  EXPECT_EQ(steps, 4);
  EXPECT_NEAR(way, 0.275, 1e-12);
}

}  // namespace
}  // namespace tessera::locate
