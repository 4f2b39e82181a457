// What vehicles teach of the floor, and what a locator gains by it.
#include "locate/magnetic_learner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "locate/filters.h"
#include "locate/synthetic_drive.h"

namespace tessera::test {
namespace {

using locate::Estimate;
using locate::MagneticLearner;
using locate::MagneticMap;

constexpr double kDegree = kPi / 180.0;

/// Iron that turns the compass by 10° to one side and to the other.
double ironAt(Point p) {
  const auto spot = [&](double x, double y, double peak) {
    const double away = distance(p, {Metres{x}, Metres{y}}).value() / 0.3;
    return peak * kDegree * std::exp(-0.5 * away * away);
  };
  return spot(0.3, 1.0, 10.0) + spot(0.9, 0.9, -10.0);
}

/// Drives straight to and fro; each report measures the compass' error to 5°, apart from all others.
struct Walker {
  MagneticLearner learner;
  double own = 0.0;     ///< rad
  double speed = 0.12;  ///< m/s
  double sigma = 5 * kDegree;
  double wrongBy = 0.0;  ///< rad, added to what is measured
  std::mt19937 random{1};
  std::normal_distribution<double> normal{};
  double now = 0.0;
  double error = 0.0;  ///< of the heading, as it is

  void pass(MagneticMap& map, double x) {
    learner.interrupt();
    error = ironAt({Metres{x}, Metres{0.0}}) + own;
    for (double y = 0.0; y < 2.0; y += speed * 0.1) {
      const Point place{Metres{x}, Metres{y}};
      now += 0.1;
      error += (1.0 - std::exp(-0.1 / locate::kCompassMemory)) * (ironAt(place) + own - error);
      Estimate moved;
      moved.at = Seconds{now};
      moved.located = true;
      moved.pose = {place, Radians{kPi / 2}};
      moved.covariance.diagonal() << 1e-4, 1e-4, 0.01;
      Estimate known = moved;
      const double measured = error + wrongBy + sigma * normal(random);
      known.covariance(2, 2) = 1.0 / (1.0 / 0.01 + 1.0 / (sigma * sigma));
      known.headingBias = Radians{known.covariance(2, 2) * measured / (sigma * sigma)};
      learner.take(moved, known, map);
      learner.teach(map);
    }
  }
};

/// RMS of what the map has wrong along a line, but for one angle for all of it, in degrees.
double wrongAlong(const MagneticMap& map, double x) {
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (double y = 0.1; y < 1.4; y += 0.05, ++count) {
    const Point place{Metres{x}, Metres{y}};
    const double off = (map.at(place).deviation - ironAt(place)) / kDegree;
    sum += off;
    squares += off * off;
  }
  return std::sqrt(squares / count - sum * sum / count / count);
}

TEST(AMagneticLearner, learnsTheFloorAtAnySpeed) {
  for (const double speed : {0.12, 0.5}) {
    MagneticMap map;
    Walker walker;
    walker.speed = speed;
    for (int i = 0; i < 15; ++i) walker.pass(map, 0.3);
    EXPECT_LT(wrongAlong(map, 0.3), 1.5) << speed;
    EXPECT_GT(map.at(Point{Metres{0.3}, Metres{1.0}}).known(), 0.7) << speed;
    EXPECT_NEAR(map.at(Point{Metres{0.9}, Metres{1.0}}).known(), 0.0, 1e-12) << "where it never was";
  }
}

TEST(AMagneticLearner, keepsTheVehiclesOwnPartApart) {
  MagneticMap map;
  Walker left, right;
  left.own = 4 * kDegree;
  right.own = -4 * kDegree;
  right.random.seed(2);
  for (int i = 0; i < 15; ++i) {
    left.pass(map, 0.3);
    right.pass(map, 0.3);
  }
  EXPECT_NEAR(left.learner.own().mean - right.learner.own().mean, 8 * kDegree, 1.5 * kDegree);
  EXPECT_LT(wrongAlong(map, 0.3), 1.5);
}

TEST(AMagneticLearner, doesNotLearnFromWhatWasBelievedBefore) {
  MagneticMap map;
  MagneticLearner learner;
  Estimate estimate;
  estimate.located = true;
  estimate.headingBias = Radians{0.15};
  estimate.covariance.diagonal() << 1e-4, 1e-4, 1e-4;
  for (int i = 0; i < 300; ++i) {
    estimate.at = Seconds{0.1 * i};
    estimate.pose.position.x = Metres{0.012 * i};
    learner.take(estimate, estimate, map);
    learner.teach(map);
  }
  EXPECT_TRUE(map.empty());
}

TEST(AMagneticLearner, teachesNothingOfAPlaceThatWasLost) {
  MagneticMap map;
  Walker walker;
  Estimate lost;
  for (int i = 0; i < 40; ++i) {
    walker.pass(map, 0.3);
    lost.at = Seconds{walker.now};
    walker.learner.take(lost, lost, map);
  }
  const double last = 2.0 - 0.5;
  map.forEach([&](locate::MagneticNode node, const locate::MagneticValue&) {
    EXPECT_LT(MagneticMap::placeOf(node).y.value(), last + 0.16) << "the last half metre before it was lost";
  });
  ASSERT_FALSE(map.empty());
}

TEST(AMagneticLearner, isNotSpoilt) {
  MagneticMap map;
  Walker good, bad;
  bad.random.seed(3);
  bad.wrongBy = 30 * kDegree;
  for (int i = 0; i < 15; ++i) good.pass(map, 0.3);
  const double before = wrongAlong(map, 0.3);
  bad.pass(map, 0.3);
  EXPECT_LT(wrongAlong(map, 0.3), before + 1.0);
  bad.learner.interrupt();
  MagneticLearner& learner = good.learner;
  const double own = learner.own().mean;
  good.wrongBy = 60 * kDegree;
  good.speed = 2.0;  // a few reports
  good.pass(map, 0.3);
  EXPECT_NEAR(learner.own().mean, own, 3 * kDegree);
}

TEST(AMagneticLearner, forgetsTheVehicleWhoseCompassIsAnother) {
  MagneticMap map;
  Walker walker;
  walker.own = 6 * kDegree;
  for (int i = 0; i < 5; ++i) walker.pass(map, 0.3);
  EXPECT_GT(walker.learner.own().mean, 2 * kDegree);
  walker.learner.restart();
  EXPECT_EQ(walker.learner.own().mean, 0.0);
  EXPECT_EQ(walker.learner.own().variance, locate::OwnDeviation{}.variance);
}

// --- a locator with the map
// ---------------------------------------------------------------------------------------------------

TEST(ALocatorWithAMagneticMap, knowsItsHeadingBetterOnAFloorWithIron) {
  const auto map = paperMap();
  auto iron = std::make_shared<MagneticMap>();
  for (std::int32_t column = -1; column <= 13; ++column)
    for (std::int32_t row = -1; row <= 13; ++row)
      ASSERT_TRUE(iron->put({column, row}, {ironAt(MagneticMap::placeOf({column, row})), kDegree * kDegree, 1}));
  DriveOptions options;
  options.iron = ironAt;
  double without = 0.0;
  double with = 0.0;
  for (options.seed = 1; options.seed <= 10; ++options.seed)
    for (const bool told : {false, true}) {
      const auto locator = std::make_unique<locate::ParticleLocator>(map, paperVehicle());
      if (told) locator->expect({iron, {2 * kDegree, kDegree * kDegree}});
      const auto samples = drive(*map, paperVehicle(), map->route("paper")->vertices, options, *locator);
      (told ? with : without) += summarise(samples, 5.0).headingRms / 10;
    }
  RecordProperty("heading_rms_deg_without", std::to_string(without / kDegree));
  RecordProperty("heading_rms_deg_with", std::to_string(with / kDegree));
  EXPECT_LT(with, 0.8 * without);
}

TEST(ALocatorWithoutAMagneticMap, isTheSameBitByBit) {
  const auto map = paperMap();
  std::vector<Sample> before;
  for (const bool told : {false, true}) {
    const auto locator = std::make_unique<locate::ParticleLocator>(map, paperVehicle());
    if (told) locator->expect({nullptr, {0.1, 0.001}});
    const auto samples = drive(*map, paperVehicle(), map->route("paper")->vertices, {}, *locator);
    for (std::size_t i = 0; told && i < samples.size(); ++i)
      ASSERT_EQ(samples[i].estimate.pose, before[i].estimate.pose) << i;
    before = samples;
  }
  ASSERT_GT(before.size(), 100U);
}

}  // namespace
}  // namespace tessera::test
