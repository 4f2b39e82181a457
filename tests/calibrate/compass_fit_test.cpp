// Ellipses of fields: exact ones are found again whatever they look like, noisy ones well enough, poor ones refused.
#include "calibrate/compass_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/angle.h"
#include "firmware/vehicle/ellipse_fit.h"

namespace tessera::test {
namespace {

using calibrate::CompassFit;
using calibrate::FieldEllipse;
using calibrate::FieldPoint;
using calibrate::fitCompass;

/// measured = iron * earth + offset + noise, at evenly spread directions of a share of the turn.
struct Iron {
  std::array<double, 3> matrix{1.0, 0.0, 1.0};  ///< xx, xy = yx, yy
  FieldPoint offset;
  double strength = 20.0;

  [[nodiscard]] FieldPoint measure(double at) const {
    const double x = strength * std::cos(at);
    const double y = strength * std::sin(at);
    return {matrix[0] * x + matrix[1] * y + offset.x, matrix[1] * x + matrix[2] * y + offset.y};
  }
  [[nodiscard]] std::vector<FieldPoint> turn(double noise, std::mt19937& random, double share = 1.0,
                                             int count = 64) const {
    std::normal_distribution<double> n{0.0, 1.0};
    std::vector<FieldPoint> points;
    for (int i = 0; i < count; ++i) {
      FieldPoint p = measure(2.0 * kPi * share * i / count);
      p.x += noise * n(random);
      p.y += noise * n(random);
      points.push_back(p);
    }
    return points;
  }
  /// Of the corrected directions, degrees.
  [[nodiscard]] double worstError(const calibrate::CompassCorrection& correction) const {
    double worst = 0.0;
    for (int i = 0; i < 360; ++i) {
      const double at = i * kPi / 180.0;
      const FieldPoint c = correction.apply(measure(at));
      worst = std::max(worst, std::abs(std::remainder(std::atan2(c.y, c.x) - at, 2.0 * kPi)));
    }
    return worst * 180.0 / kPi;
  }
};

Iron anyIron(std::mt19937& random) {
  std::uniform_real_distribution<double> share{0.0, 1.0};
  Iron iron;
  iron.matrix = {0.7 + 0.8 * share(random), 0.4 * share(random) - 0.2, 0.7 + 0.8 * share(random)};
  iron.offset = {300.0 * share(random) - 150.0, 300.0 * share(random) - 150.0};
  iron.strength = 16.0 + 20.0 * share(random);
  return iron;
}

TEST(CompassFit, findsAnyExactEllipseAgain) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::mt19937 random{seed};
    const Iron iron = anyIron(random);
    const auto fit = fitCompass(iron.turn(0.0, random));
    ASSERT_TRUE(fit) << seed;
    EXPECT_NEAR(fit->ellipse.centre.x, iron.offset.x, 1e-6) << seed;
    EXPECT_NEAR(fit->ellipse.centre.y, iron.offset.y, 1e-6) << seed;
    EXPECT_LT(fit->misfit, 1e-6) << seed;
    EXPECT_LT(iron.worstError(fit->correction), 1e-5) << seed;
    EXPECT_FALSE(fit->objection()) << seed << fit->objection()->english();
    EXPECT_GE(fit->ellipse.longAxis, fit->ellipse.shortAxis);
  }
}

TEST(CompassFit, drawsAnOutlineThatRunsThroughThePoints) {
  std::mt19937 random{3};
  const Iron iron = anyIron(random);
  const auto points = iron.turn(0.0, random);
  const auto outline = fitCompass(points)->ellipse.outline(720);
  for (const FieldPoint& p : points) {
    double nearest = 1e9;
    for (const FieldPoint& o : outline) nearest = std::min(nearest, std::hypot(o.x - p.x, o.y - p.y));
    EXPECT_LT(nearest, 0.3);
  }
}

// A chip turned on its board, or in another unit, must come to the same.
TEST(CompassFit, turnsAndGrowsWithItsPoints) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    std::mt19937 random{seed};
    const auto points = anyIron(random).turn(0.3, random);
    const double angle = 0.1 * seed;
    std::vector<FieldPoint> turned;
    for (const FieldPoint& p : points)
      turned.push_back({1.5 * (std::cos(angle) * p.x - std::sin(angle) * p.y),
                        1.5 * (std::sin(angle) * p.x + std::cos(angle) * p.y)});
    const auto one = fitCompass(points);
    const auto other = fitCompass(turned);
    ASSERT_TRUE(one && other) << seed;
    EXPECT_NEAR(other->radius, 1.5 * one->radius, 1e-6) << seed;
    EXPECT_NEAR(other->ellipse.longAxis, 1.5 * one->ellipse.longAxis, 1e-6) << seed;
    EXPECT_NEAR(other->misfit, one->misfit, 1e-9) << seed;
    EXPECT_NEAR(other->ellipse.centre.x,
                1.5 * (std::cos(angle) * one->ellipse.centre.x - std::sin(angle) * one->ellipse.centre.y), 1e-6);
  }
}

TEST(CompassFit, leavesLessThanADegreeWithANoisyChip) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    std::mt19937 random{seed};
    Iron iron;
    iron.matrix = {1.6, 0.4, 0.8};
    iron.offset = {75.0, -48.0};
    const auto fit = fitCompass(iron.turn(0.3, random));
    ASSERT_TRUE(fit) << seed;
    EXPECT_FALSE(fit->objection()) << seed;
    EXPECT_LT(iron.worstError(fit->correction), 1.5) << seed;
  }
}

TEST(CompassFit, agreesWithTheVehiclesOwnFit) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    std::mt19937 random{seed};
    const auto points = anyIron(random).turn(0.2, random);
    std::vector<firmware::Field> fields;
    for (const FieldPoint& p : points) fields.push_back({static_cast<float>(p.x), static_cast<float>(p.y)});
    const auto own = firmware::fitEllipse(fields);
    const auto fit = fitCompass(points);
    ASSERT_TRUE(own && fit) << seed;
    const calibrate::CompassCorrection theirs{own->correction.offsetX, own->correction.offsetY, own->correction.xx,
                                              own->correction.xy,      own->correction.yx,      own->correction.yy};
    EXPECT_LT(calibrate::largestTurn(theirs, fit->correction, points) * 180.0 / kPi, 0.7) << seed;
  }
}

TEST(CompassFit, saysByHowMuchTwoCorrectionsDiffer) {
  std::mt19937 random{1};
  Iron iron;
  iron.offset = {10.0, 0.0};
  const auto points = iron.turn(0.0, random, 1.0, 360);
  // Uncorrected, the circle lies half its radius beside zero: asin(1/2).
  EXPECT_NEAR(calibrate::largestTurn({}, fitCompass(points)->correction, points), kPi / 6.0, 1e-3);
}

TEST(CompassFit, refusesATurnThatDidNotGoAllAround) {
  for (const double share : {0.3, 0.5, 0.8}) {
    std::mt19937 random{4};
    const auto fit = fitCompass(Iron{}.turn(0.1, random, share));
    ASSERT_TRUE(fit) << share;
    EXPECT_GT(fit->missing(), 2) << share;
    ASSERT_TRUE(fit->objection()) << share;
    EXPECT_NE(fit->objection()->english().find("did not turn all around"), std::string::npos);
  }
}

TEST(CompassFit, refusesFieldsThatAreNotTheEarthsAndScatteredOnes) {
  std::mt19937 random{5};
  const auto says = [&](const Iron& iron, double noise) {
    const auto fit = fitCompass(iron.turn(noise, random, 1.0, 360));
    return fit && fit->objection() ? fit->objection()->english() : std::string{"nothing"};
  };
  Iron iron;
  iron.strength = 4.0;
  EXPECT_NE(says(iron, 0.0).find("A horizontal field of 4 µT"), std::string::npos) << says(iron, 0.0);
  iron.strength = 90.0;
  EXPECT_NE(says(iron, 0.0).find("cannot be the earth's"), std::string::npos);
  iron.strength = 20.0;
  EXPECT_NE(says(iron, 2.5).find("on no ellipse"), std::string::npos) << says(iron, 2.5);
  iron.matrix = {3.0, 0.0, 0.5};
  EXPECT_NE(says(iron, 0.0).find("times as long as wide"), std::string::npos) << says(iron, 0.0);
}

TEST(CompassFit, findsNoEllipseInALineAPointOrHardlyAnything) {
  std::vector<FieldPoint> line;
  for (int i = 0; i < 40; ++i) line.push_back({1.0 * i, 2.0 * i});
  EXPECT_FALSE(fitCompass(line));
  EXPECT_FALSE(fitCompass(std::vector<FieldPoint>(40, FieldPoint{3.0, 4.0})));
  EXPECT_FALSE(fitCompass(std::span{line}.first(5)));
  EXPECT_FALSE(fitCompass({}));
}

// Whatever a vehicle says, the answer is finite or none.
TEST(CompassFit, bearsAnyPoints) {
  for (unsigned seed = 1; seed <= 500; ++seed) {
    std::mt19937 random{seed};
    std::uniform_int_distribution<int> number{-32768, 32767};
    std::uniform_int_distribution<int> few{-2, 2};
    std::vector<FieldPoint> points;
    for (unsigned i = 0; i < 6 + seed % 60; ++i)
      points.push_back(seed % 2 == 0 ? FieldPoint{0.025 * number(random), 0.025 * number(random)}
                                     : FieldPoint{1.0 * few(random), 1.0 * few(random)});
    const auto fit = fitCompass(points);
    if (!fit) continue;
    EXPECT_TRUE(std::isfinite(fit->radius) && std::isfinite(fit->misfit)) << seed;
    EXPECT_TRUE(std::isfinite(fit->correction.xx + fit->correction.xy + fit->correction.offsetX)) << seed;
    (void)fit->objection();
  }
}

}  // namespace
}  // namespace tessera::test
