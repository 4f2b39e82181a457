#include "app/experiment/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "app/experiment/carried.h"
#include "app/experiment/summary.h"

namespace tessera::experiment {
namespace {

const Polyline kStraight{{{Metres{0}, Metres{0}}, {Metres{2}, Metres{0}}}};

// A vehicle that drives along the x axis at 0.1 m/s, `off` beside the route; the estimate is `error` behind it.
std::vector<Sample> drive(double off, double error, const std::vector<double>& xs) {
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    Sample s;
    s.belief.at = s.truth.at = Seconds{0.1 * static_cast<double>(i)};
    s.truth.pose.position = {Metres{xs[i]}, Metres{off}};
    s.truth.speed = MetresPerSecond{0.1};
    s.belief.pose.position = {Metres{xs[i] - error}, Metres{off}};
    s.belief.driving = s.belief.located = true;
    samples.push_back(s);
  }
  return samples;
}

std::vector<double> steady() {
  std::vector<double> xs;
  for (int i = 0; i <= 200; ++i) xs.push_back(0.01 * i);
  return xs;
}

TEST(Metrics, tellPositionErrorCrossTrackAndSpeedOfASteadyRun) {
  const Metrics m = evaluate(kStraight, drive(0.03, 0.02, steady()), MetresPerSecond{0.125});
  EXPECT_NEAR(m.positionErrorMean.value(), 0.02, 1e-9);
  EXPECT_NEAR(m.positionErrorP95.value(), 0.02, 1e-9);
  EXPECT_NEAR(m.crossTrackRms.value(), 0.03, 1e-9);
  EXPECT_NEAR(m.crossTrackMax.value(), 0.03, 1e-9);
  EXPECT_NEAR(m.meanSpeedRatio, 0.8, 1e-9);
  EXPECT_NEAR(m.duration.value(), 20.0, 1e-9);
  EXPECT_NEAR(m.endError.value(), 0.03, 1e-9);
  EXPECT_EQ(m.reversals, 0);
}

TEST(Metrics, ofARunThatMeasuredNothingAreNoFigures) {
  const auto figures = toJson(evaluate(kStraight, {}, MetresPerSecond{0.1}), false);
  EXPECT_TRUE(figures["position_error_mean_m"].is_null());
  EXPECT_TRUE(figures["reversals"].is_null());
  EXPECT_EQ(figures["samples"], 0);
  EXPECT_EQ(figures["finished"], false);
  EXPECT_TRUE(toJson(evaluate(kStraight, drive(0, 0, steady()), MetresPerSecond{0.1}), true)["reversals"].is_number());
}

TEST(Metrics, tellTheLargestPositionErrorFromTheFirstPlaceOn) {
  auto samples = drive(0, 0.02, steady());
  samples[0].belief.located = false;
  samples[0].belief.pose.position.x = Metres{9};
  EXPECT_NEAR(evaluate(kStraight, samples, MetresPerSecond{0.1}).positionErrorMax.value(), 0.02, 1e-9);
  samples[50].belief.located = false;
  samples[50].belief.pose.position.y = Metres{0.3};
  EXPECT_GT(evaluate(kStraight, samples, MetresPerSecond{0.1}).positionErrorMax.value(), 0.29) << "lost on the way";
}

TEST(Metrics, countATurnBackOfMoreThanTwoCentimetresOnce) {
  auto xs = steady();
  for (int i = 0; i < 5; ++i) xs.insert(xs.begin() + 100 + i, 0.99 - 0.01 * i);  // back by 5 cm, then a jump ahead
  EXPECT_EQ(evaluate(kStraight, drive(0, 0, xs), MetresPerSecond{0.1}).reversals, 1);
}

TEST(Metrics, doNotCountATremblingOfOneCentimetre) {
  auto xs = steady();
  xs.insert(xs.begin() + 100, 0.985);
  EXPECT_EQ(evaluate(kStraight, drive(0, 0, xs), MetresPerSecond{0.1}).reversals, 0);
}

TEST(Metrics, countEveryOneOfSeveralTurnsBack) {
  std::vector<double> xs;
  for (int wave = 0; wave < 3; ++wave) {
    for (int i = 0; i <= 20; ++i) xs.push_back(0.3 * wave + 0.02 * i);
    for (int i = 0; i <= 5; ++i) xs.push_back(0.3 * wave + 0.4 - 0.02 * i);
  }
  EXPECT_EQ(evaluate(kStraight, drive(0, 0, xs), MetresPerSecond{0.1}).reversals, 3);
}

TEST(Metrics, ignoreTicksBeforeTheOrderAndAfterItsEnd) {
  auto samples = drive(0, 0.01, steady());
  for (std::size_t i = 0; i < 50; ++i) {
    samples[i].belief.driving = false;
    samples[i].belief.pose.position.x = Metres{99};
  }
  EXPECT_NEAR(evaluate(kStraight, samples, MetresPerSecond{0.1}).positionErrorMean.value(), 0.01, 1e-9);
}

TEST(Metrics, doNotMistakeANearLegForThePresentOne) {
  // There and back 10 cm apart: on the way out the projection must stay on the first leg.
  const Polyline hairpin{
      {{Metres{0}, Metres{0}}, {Metres{2}, Metres{0}}, {Metres{2}, Metres{0.1}}, {Metres{0}, Metres{0.1}}}};
  auto xs = steady();
  xs.resize(160);  // near the hairpin's bend both legs are right answers
  const Metrics m = evaluate(hairpin, drive(0.06, 0, xs), MetresPerSecond{0.1});
  EXPECT_EQ(m.reversals, 0);
  EXPECT_NEAR(m.crossTrackRmsOffCorners.value(), 0.06, 1e-3);
}

TEST(Metrics, doNotTakeATrembleInsideACornerForATurnBack) {
  const Polyline corner{{{Metres{0}, Metres{0}}, {Metres{1}, Metres{0}}, {Metres{1}, Metres{1}}}};
  std::vector<Sample> samples;
  for (int i = 0; i <= 96; ++i) samples.push_back(drive(0.02, 0, {0.01 * i}).front());
  // Stands 2 cm inside the corner and trembles by half a millimetre while it turns.
  for (int i = 0; i < 20; ++i) {
    Sample s = drive(0.02, 0, {0.98 + (i % 2 == 0 ? 0.0005 : -0.0005)}).front();
    s.truth.pose.position.y = Metres{0.02 + (i % 2 == 0 ? 0.0005 : -0.0005)};
    samples.push_back(s);
  }
  EXPECT_EQ(evaluate(corner, samples, MetresPerSecond{0.1}).reversals, 0);
}

TEST(Metrics, seeATurnBackIntoTheLegBeforeTheCorner) {
  const Polyline corner{{{Metres{0}, Metres{0}}, {Metres{1}, Metres{0}}, {Metres{1}, Metres{1}}}};
  std::vector<Sample> samples;
  for (int i = 0; i <= 100; ++i) samples.push_back(drive(0, 0, {0.01 * i}).front());
  for (int i = 0; i <= 10; ++i) samples.push_back(drive(0, 0, {1.0 - 0.01 * i}).front());
  EXPECT_EQ(evaluate(corner, samples, MetresPerSecond{0.1}).reversals, 1);
}

TEST(Metrics, ofAnEmptyRunAreZero) { EXPECT_EQ(evaluate(kStraight, {}, MetresPerSecond{0.1}).samples, 0U); }

TEST(TruthTrack, interpolatesHeadingsTheShortWayRound) {
  const TruthTrack track{{{Seconds{0}, {{}, Radians{3.1}}, {}}, {Seconds{1}, {{}, Radians{-3.1}}, {}}}};
  EXPECT_NEAR(std::abs(track.at(Seconds{0.5})->pose.heading.value()), kPi, 1e-9);
  EXPECT_FALSE(track.at(Seconds{1.5}).has_value());
}

// Ticks whose errors are as large as their covariances say, or `share` of that.
std::vector<double> honest(double share) {
  std::mt19937 random{7};
  std::normal_distribution<double> normal;
  std::vector<double> nees;
  for (int i = 0; i < 500; ++i) {
    Sample s;
    s.belief.doubt = {4e-4, 1e-4, 1e-4};
    // Of that covariance: x = 2 cm · a, y = 0.5 cm · a + √0.75 cm · b.
    const double a = normal(random);
    const double b = normal(random);
    s.belief.pose.position = {Metres{share * 0.02 * a}, Metres{share * (0.005 * a + 0.01 * std::sqrt(0.75) * b)}};
    nees.push_back(neesOf(s).value());
  }
  return nees;
}

TEST(Consistency, holdsForErrorsAsLargeAsClaimed) {
  const Consistency c = consistencyOf(honest(1.0));
  EXPECT_NEAR(c.neesMean, 2.0, 0.2);
  EXPECT_GT(c.independent, 300.0);
  EXPECT_TRUE(c.holds());
  EXPECT_LT(c.low, 2.0);
  EXPECT_GT(c.high, 2.0);
}

TEST(Consistency, isRefusedToThoseWhoClaimTooMuchOrTooLittle) {
  EXPECT_FALSE(consistencyOf(honest(1.5)).holds());
  EXPECT_FALSE(consistencyOf(honest(0.6)).holds());
}

TEST(Consistency, countsTicksThatRepeatEachOtherOnce) {
  std::vector<double> repeated;
  for (const double e : honest(1.0)) repeated.insert(repeated.end(), 10, e);
  const Consistency c = consistencyOf(repeated);
  EXPECT_GT(c.independent, 300.0);
  EXPECT_LT(c.independent, 700.0);
}

// A run's errors, as large as claimed, that last: each of two axes is forgotten over `memory` s, ticks of 0.1 s.
std::vector<double> lasting(std::mt19937& random, double memory, std::size_t ticks) {
  std::normal_distribution<double> normal;
  const double keep = std::exp(-0.1 / memory);
  const double fresh = std::sqrt(1.0 - keep * keep);
  double x = normal(random);
  double y = normal(random);
  std::vector<double> nees;
  for (std::size_t i = 0; i < ticks; ++i) {
    nees.push_back(x * x + y * y);
    x = keep * x + fresh * normal(random);
    y = keep * y + fresh * normal(random);
  }
  return nees;
}

TEST(Consistency, holdsInAboutNinetyFiveOfAHundredHonestRunsWhoseErrorsLast) {
  std::mt19937 random{11};
  for (const auto& [memory, ticks] : {std::pair{0.5, 480}, {1.0, 480}, {1.5, 480}, {0.5, 150}}) {
    int held = 0;
    constexpr int kRuns = 1000;
    for (int run = 0; run < kRuns; ++run)
      held += consistencyOf(lasting(random, memory, static_cast<std::size_t>(ticks))).holds() ? 1 : 0;
    EXPECT_GT(held, 920) << memory << " s";
    EXPECT_LT(held, 970) << memory << " s";
  }
}

TEST(Consistency, isRefusedToMostRunsThatClaimTwoThirdsOfTheVariance) {
  std::mt19937 random{12};
  int held = 0;
  for (int run = 0; run < 200; ++run) {
    std::vector<double> nees = lasting(random, 1.0, 480);
    for (double& e : nees) e *= 1.5;
    held += consistencyOf(nees).holds() ? 1 : 0;
  }
  EXPECT_LT(held, 60);
}

TEST(Consistency, isNoneWithoutACovariance) {
  EXPECT_FALSE(neesOf(Sample{}).has_value());
  EXPECT_FALSE(consistencyOf({}).holds());
}

TEST(Carried, isFoundWhereTheErrorStaysSmallNotWhereItPassesThrough) {
  auto samples = drive(0, 0, steady());
  const auto off = [](Sample& s, double by) { s.belief.pose.position.y = Metres{by}; };
  for (std::size_t i = 50; i < 120; ++i) off(samples[i], 0.5);
  off(samples[80], 0.0);  // by chance, for one tick
  const auto way = foundAfter(samples, Seconds{5.0});
  ASSERT_TRUE(way.has_value());
  EXPECT_NEAR(way->value(), 0.70, 1e-6);
  EXPECT_NEAR(wronglySure(samples, Seconds{5.0}).value(), 6.9, 1e-6);
  for (std::size_t i = 100; i < 120; ++i) samples[i].belief.doubted = true;
  EXPECT_NEAR(wronglySure(samples, Seconds{5.0}).value(), 4.9, 1e-6) << "what says that it may be wrong is not sure";
}

TEST(Carried, isNotChargedForTheWayThatItWasCarried) {
  auto samples = drive(0, 0, steady());
  for (std::size_t i = 51; i < samples.size(); ++i) {
    samples[i].truth.pose.position.y += Metres{0.7};
    samples[i].belief.pose.position.y += Metres{i < 80 ? 0.0 : 0.7};
  }
  const auto way = foundAfter(samples, Seconds{5.0});
  ASSERT_TRUE(way.has_value());
  EXPECT_NEAR(way->value(), 0.29, 1e-6);  // one step of 1 cm is the one in which it was carried
}

TEST(Carried, isNotFoundWhileItDoesNotSaySo) {
  auto samples = drive(0, 0, steady());
  for (Sample& s : samples) s.belief.located = false;
  EXPECT_FALSE(foundAfter(samples, Seconds{5.0}).has_value());
}

}  // namespace
}  // namespace tessera::experiment
