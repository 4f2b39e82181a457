#include "app/experiment/metrics.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tessera::experiment
