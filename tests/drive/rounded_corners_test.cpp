// Corners that a vehicle may cut, in the closed loop: where it was, how fast, and how long it took. Each test prints
// what it measured.
#include <gmock/gmock.h>

#include <cstdio>
#include <random>

#include "drive/closed_loop.h"
#include "drive/driven_way.h"

namespace tessera::test {
namespace {

using drive::Phase;

LoopResult driven(const floor::Route& route, const LoopOptions& options, std::string_view follower = "look-ahead") {
  const LoopResult r = closeLoop(follower, route, options);
  std::printf(
      "cut %4.1f cm, %2.0f cm/s, T %.2f s: %s in %5.1f s, off the line %.2f, off a vertex %.2f cm, no slower than "
      "%.3f m/s, lost %.2f, end %.2f cm\n",
      100 * options.cut, 100 * options.speed, options.up + options.down, r.finished ? "finished" : "NOT FINISHED",
      r.duration, 100 * r.crossTrackMax, 100 * r.missedVertex, r.lowestSpeed, 100 * r.largestLoss, 100 * r.endError);
  return r;
}

LoopOptions withCut(double cut, double speed, double delay = 0.25) {
  LoopOptions options;
  options.cut = cut;
  options.speed = speed;
  options.up = options.down = delay / 2;
  return options;
}

floor::Route through(std::initializer_list<std::pair<double, double>> places) {
  floor::Route route{"test", {}, Metres{0.2}};
  for (const auto& [x, y] : places) route.vertices.push_back({Metres{x}, Metres{y}});
  return route;
}

TEST(RoundedCorners, areDrivenWithoutAStopWithinTheCut) {
  for (const double delay : {0.25, 0.75}) {
    for (const double speed : {0.05, 0.12, 0.30, 0.50}) {
      const LoopResult onTheSpot = driven(paperRoute(), withCut(0.0, speed, delay));
      for (const double cut : {0.05, 0.10, 0.15}) {
        const LoopResult r = driven(paperRoute(), withCut(cut, speed, delay));
        SCOPED_TRACE(testing::Message() << speed << " m/s, cut " << cut << ", T " << delay);
        EXPECT_TRUE(r.finished);
        EXPECT_THAT(r.phases, ::testing::ElementsAre(Phase::OnLeg, Phase::Finished));
        EXPECT_GT(r.lowestSpeed, std::min(0.9 * speed, 0.09)) << "it does not stop";
        EXPECT_LT(r.missedVertex, cut + 0.01);
        EXPECT_LT(r.crossTrackMax, cut * std::sqrt(0.5) + 0.01) << "from either leg of a right angle";
        EXPECT_LT(r.largestLoss, 0.02);
        EXPECT_LT(r.endError, 0.02);
        // Fast vehicles need wide arcs: 5 cm save them nothing.
        EXPECT_LT(r.duration, onTheSpot.duration - (speed < 0.4 || cut > 0.05 ? 1.0 : 0.0));
      }
    }
  }
}

// As at 2.4 kbit/s, where the next command comes after 0.75 s and later: what is missing to the course must not be told
// twice over.
TEST(RoundedCorners, areDrivenWithoutSwingingWhereCommandsHoldForLong) {
  for (const double period : {0.75, 1.1}) {
    for (const double cut : {0.05, 0.15}) {
      for (std::uint32_t seed = 1; seed <= 5; ++seed) {
        LoopOptions options = withCut(cut, 0.12, 0.5);
        options.period = period;
        options.poseNoise = 0.008;
        options.headingNoise = 0.03;
        options.seed = seed;
        const LoopResult r = driven(paperRoute(), options);
        SCOPED_TRACE(testing::Message() << "every " << period << " s, cut " << cut << ", seed " << seed);
        EXPECT_TRUE(r.finished);
        EXPECT_LT(r.duration, 60.0);
        EXPECT_LT(r.crossTrackMax, cut * std::sqrt(0.5) + 0.05);
        EXPECT_LT(r.largestLoss, 0.02);
      }
    }
  }
}

TEST(RoundedCorners, bearANoisyPoseAVariableDelayAndAnotherVehicleThanExpected) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    for (const double speed : {0.12, 0.30}) {
      LoopOptions options = withCut(0.10, speed, 0.4);
      options.poseNoise = 0.008;
      options.headingNoise = 0.02;
      options.jitter = 0.4;
      options.gain = 4.0;
      options.acceleration = 0.4;
      options.lag = 0.15;
      options.seed = seed;
      const LoopResult r = driven(paperRoute(), options);
      EXPECT_TRUE(r.finished);
      EXPECT_GT(r.lowestSpeed, 0.05);
      EXPECT_LT(r.missedVertex, 0.10 + 0.04);
      EXPECT_LT(r.largestLoss, 0.02);
    }
  }
}

TEST(RoundedCorners, areDrivenNoFasterThanTheirLegs) {
  floor::Route route = through({{0, 0}, {1, 0}, {1, 1}, {2, 1}});
  route.legSpeeds = {std::nullopt, MetresPerSecond{0.05}, std::nullopt};
  for (const double delay : {0.1, 0.25, 0.75}) {
    const LoopResult r = driven(route, withCut(0.15, 0.20, delay));
    std::printf("    top speeds %.3f %.3f %.3f m/s\n", r.topSpeeds[0], r.topSpeeds[1], r.topSpeeds[2]);
    EXPECT_TRUE(r.finished);
    EXPECT_LE(r.topSpeeds[1], 0.055);
    EXPECT_GT(r.topSpeeds[0], 0.15);
    EXPECT_GT(r.topSpeeds[2], 0.15);
  }
}

TEST(RoundedCorners, turnRoundOnTheSpotWhereTheRouteGoesBack) {
  const LoopResult r = driven(through({{0, 0}, {1, 0}, {0, 0}}), withCut(0.3, 0.2));
  EXPECT_TRUE(r.finished);
  EXPECT_THAT(r.phases, ::testing::Contains(Phase::Turning));
  EXPECT_LT(r.crossTrackMax, 0.015);
  EXPECT_LT(r.endError, 0.02);
}

TEST(RoundedCorners, doNotConfuseLegsBesideEachOther) {
  // Two arcs make a half circle of 6 cm; the way back passes 12 cm beside the way there.
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    LoopOptions options = withCut(0.10, 0.12);
    options.poseNoise = 0.02;
    options.seed = seed;
    const auto comb = through({{0, 0}, {1, 0}, {1, 0.12}, {0, 0.12}, {0, 0.24}, {1, 0.24}});
    const LoopResult r = driven(comb, options);
    EXPECT_TRUE(r.finished);
    EXPECT_LT(r.missedVertex, 0.10 + 0.05) << "it must not have turned back early";
    EXPECT_GT(r.duration, 2.9 / 0.12);
  }
}

TEST(RoundedCorners, reachTheEndOfAnyRoute) {
  std::mt19937 random{7};
  const auto number = [&](double low, double high) { return std::uniform_real_distribution{low, high}(random); };
  for (int n = 0; n < 40; ++n) {
    floor::Route route = through({{0, 0}});
    double heading = 0.0;
    for (int leg = 0; leg < 6; ++leg) {
      route.vertices.push_back(route.vertices.back() + turned({Metres{number(0.05, 1.0)}, {}}, Radians{heading}));
      heading += number(-kPi, kPi);
    }
    const double cut = number(0.02, 0.3);
    const LoopResult r = driven(route, withCut(cut, number(0.08, 0.4), number(0.1, 0.75)));
    EXPECT_TRUE(r.finished) << n;
    EXPECT_LT(r.missedVertex, cut + 0.015) << n;
    EXPECT_LT(r.endError, 0.02) << n;
    EXPECT_GE(r.lowestCommand, 0.0) << n;
  }
}

TEST(RoundedCorners, areNoneOfTheOtherControllers) {
  for (const std::string_view follower : drive::followerNames().subspan(1)) {
    const LoopResult plain = driven(paperRoute(), withCut(0.0, 0.12), follower);
    const LoopResult cut = driven(paperRoute(), withCut(0.15, 0.12), follower);
    EXPECT_EQ(plain.duration, cut.duration) << follower;
    EXPECT_EQ(plain.missedVertex, cut.missedVertex) << follower;
    EXPECT_EQ(plain.endError, cut.endError) << follower;
  }
}

// Lets pass up to a place on the way that it is told of.
struct Gate final : drive::WayGuard {
  void laid(const Polyline& laidWay) override { way = laidWay; }
  const drive::StretchLimits& limits() const override { return none; }
  Metres mayGoTo(Metres, Metres) override { return at; }
  Polyline way;
  drive::StretchLimits none;
  Metres at{1e9};
};

TEST(RoundedCorners, progressIsToldAlongTheRouteAndLeaveAlongTheWay) {
  drive::VehicleAbility ability;
  ability.cornerCut = Metres{0.15};
  const auto gate = std::make_shared<Gate>();
  const floor::Route route = paperRoute();
  const RoundedLine way = drive::drivenWay(route, ability);
  const auto follower = *drive::makeRouteFollower("look-ahead", {route, ability, {}, gate});
  const double drawn = Polyline{route.vertices}.length().value();
  const double length = way.line().length().value();
  EXPECT_EQ(follower->route().vertices(), route.vertices);
  ASSERT_LT(length, drawn - 0.4) << "four corners are shorter than drawn";
  double last = 0.0;
  for (double on = 0.0; on < length - 0.2; on += 0.01) {
    const Pose pose{way.line().at(Metres{on}), way.line().headingOf(way.line().legAt(Metres{on}))};
    const drive::VehicleState state{Seconds{on}, pose, MetresPerSecond{0.1}, {}, Metres{}, true};
    const drive::Decision d = follower->decide({state, Seconds{0.2}}, Seconds{on});
    ASSERT_EQ(d.phase, Phase::OnLeg) << on;
    ASSERT_NEAR(d.progress.value(), way.onDrawn(Metres{on}).value(), 1e-6);
    ASSERT_NEAR(d.progress.value() + d.remaining.value(), drawn, 1e-9);
    ASSERT_EQ(d.leg, follower->route().legAt(d.progress));
    ASSERT_NEAR(d.crossTrack.value(), 0.0, 1e-6) << "it is where it should be";
    ASSERT_GE(d.progress.value(), last);
    last = d.progress.value();
  }
  EXPECT_NEAR(gate->way.length().value(), length, 1e-9);
  gate->at = Metres{length - 0.15};
  const Pose pose{way.line().at(gate->at), way.line().headingOf(way.line().legCount() - 1)};
  const drive::VehicleState state{Seconds{9}, pose, MetresPerSecond{0.1}, {}, Metres{}, true};
  EXPECT_EQ(follower->decide({state, Seconds{0.2}}, Seconds{9}).phase, Phase::Waiting) << "where the way ends for now";
}

}  // namespace
}  // namespace tessera::test
