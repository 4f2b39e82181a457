// The controllers on the publication's route and on nastier ones. Each test prints what it measured; the numbers in
// docs/decisions/0004-locator-and-controller.md are these.
#include "drive/closed_loop.h"

#include <gmock/gmock.h>

#include <cstdio>
#include <string>

namespace tessera::test {
namespace {

using drive::Phase;

LoopResult report(const char* what, std::string_view follower, const floor::Route& route, const LoopOptions& options) {
  const LoopResult r = closeLoop(follower, route, options);
  std::printf(
      "%-15s %-30s %4.0f cm/s, T %.2f s: %s in %5.1f s, across rms %.2f max %.2f cm, lost %.2f cm, end %.2f cm, cruise "
      "%.3f\n",
      std::string{follower}.c_str(), what, 100 * options.speed, options.up + options.down,
      r.finished ? "finished" : "NOT FINISHED", r.duration, 100 * r.crossTrackRms, 100 * r.crossTrackMax,
      100 * r.largestLoss, 100 * r.endError, r.cruise);
  return r;
}

floor::Route routeOf(std::initializer_list<std::pair<double, double>> places) {
  floor::Route route;
  route.name = "test";
  for (const auto& [x, y] : places) route.vertices.push_back({Metres{x}, Metres{y}});
  return route;
}

LoopOptions at(double speed, double delay) {
  LoopOptions options;
  options.speed = speed;
  options.up = options.down = delay / 2;
  return options;
}

TEST(ClosedLoop, followsThePapersRouteAtEverySpeed) {
  for (const double speed : {0.05, 0.08, 0.12, 0.20, 0.30}) {
    const LoopResult r = report("paper's route", "look-ahead", paperRoute(), at(speed, 0.25));
    EXPECT_TRUE(r.finished) << speed;
    EXPECT_LT(r.crossTrackRms, 0.015) << speed;
    EXPECT_LT(r.largestLoss, 0.02) << speed;
    EXPECT_LT(r.endError, 0.02) << speed;
    EXPECT_GE(r.lowestCommand, 0.0) << speed;
    EXPECT_GT(r.cruise, 0.8 * speed) << speed;
  }
}

TEST(ClosedLoop, drivesEachLegNoFasterThanItMay) {
  // Straight on, so that nothing but the legs' speeds slows it down.
  floor::Route route = routeOf({{0, 0}, {1.5, 0}, {2.5, 0}, {4, 0}});
  route.legSpeeds = {std::nullopt, MetresPerSecond{0.08}, std::nullopt};
  for (const double delay : {0.1, 0.25, 0.75}) {
    for (const double noise : {0.0, 0.02}) {
      LoopOptions options = at(0.30, delay);
      options.poseNoise = noise;
      const LoopResult r = report("slow in the middle", "look-ahead", route, options);
      std::printf("    top speeds %.3f %.3f %.3f m/s\n", r.topSpeeds[0], r.topSpeeds[1], r.topSpeeds[2]);
      ASSERT_TRUE(r.finished);
      EXPECT_LE(r.topSpeeds[1], 0.085 + noise) << delay;
      EXPECT_GE(r.topSpeeds[1], 0.075) << "and no slower than it has to be";
      const double fast = std::min(0.29, 0.8 * 0.25 * 0.60 / (options.period + 0.05));
      EXPECT_GT(r.topSpeeds[0], fast) << delay;
      EXPECT_GT(r.topSpeeds[2], fast) << "it speeds up again behind it";
    }
  }
  for (const std::string_view follower : drive::followerNames()) {
    const LoopResult r = report("slow in the middle", follower, route, at(0.20, 0.25));
    EXPECT_TRUE(r.finished);
    EXPECT_LE(r.topSpeeds[1], 0.10) << "whoever leads it";
  }
}

TEST(ClosedLoop, drivesALegThatIsSlowerThanItsCreep) {
  floor::Route route = routeOf({{0, 0}, {0.5, 0}, {0.6, 0}, {1, 0}});
  route.legSpeeds = {std::nullopt, MetresPerSecond{0.01}, std::nullopt};
  const LoopResult r = report("very slow in the middle", "look-ahead", route, at(0.12, 0.25));
  EXPECT_TRUE(r.finished);
  EXPECT_LE(r.topSpeeds[1], 0.012);
}

TEST(ClosedLoop, bearsLongDelays) {
  for (const double delay : {0.1, 0.5, 0.75, 1.5}) {
    const LoopResult r = report("paper's route", "look-ahead", paperRoute(), at(0.20, delay));
    EXPECT_TRUE(r.finished) << delay;
    EXPECT_LT(r.crossTrackRms, 0.015) << delay;
    EXPECT_LT(r.largestLoss, 0.02) << delay;
  }
}

TEST(ClosedLoop, bearsANoisyPoseAVariableDelayAndAnotherVehicleThanExpected) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    for (const double speed : {0.05, 0.12, 0.20}) {
      LoopOptions options = at(speed, 0.4);
      options.poseNoise = 0.008;
      options.headingNoise = 0.02;
      options.jitter = 0.4;
      options.gain = 4.0;
      options.acceleration = 0.4;
      options.lag = 0.15;
      options.seed = seed;
      const LoopResult r = report("noise, jitter, other vehicle", "look-ahead", paperRoute(), options);
      EXPECT_TRUE(r.finished) << speed;
      EXPECT_LT(r.crossTrackRms, 0.03) << speed;
      EXPECT_LT(r.largestLoss, 0.02) << speed;
      EXPECT_LT(r.endError, 0.05) << speed;
    }
  }
}

TEST(ClosedLoop, thePublicationsControllerSwingsWhereTheNewOneDoesNot) {
  LoopOptions slow = at(0.05, 0.75);
  LoopOptions fast = at(0.20, 0.75);
  for (LoopOptions* options : {&slow, &fast}) {
    options->poseNoise = 0.02;
    options->period = 0.4;
  }
  const LoopResult calm = report("paper's route", "control-points", paperRoute(), slow);
  const LoopResult wild = report("paper's route", "control-points", paperRoute(), fast);
  const LoopResult ours = report("paper's route", "look-ahead", paperRoute(), fast);
  EXPECT_TRUE(calm.finished);
  EXPECT_GT(wild.crossTrackMax, 1.5 * calm.crossTrackMax);
  EXPECT_LT(ours.crossTrackRms, wild.crossTrackRms);
  EXPECT_LT(ours.largestLoss, 0.02);
}

TEST(ClosedLoop, drivesToARouteThatBeginsElsewhere) {
  LoopOptions options = at(0.12, 0.25);
  options.start = Pose{{Metres{1.0}, Metres{1.0}}, Radians{2.0}};
  const LoopResult r = report("start away from it", "look-ahead", paperRoute(), options);
  EXPECT_TRUE(r.finished);
  EXPECT_LT(r.crossTrackRms, 0.015);
  EXPECT_LT(r.endError, 0.02);
  EXPECT_THAT(r.phases, ::testing::Contains(Phase::Approaching));
  EXPECT_EQ(r.phases.back(), Phase::Finished);
}

TEST(ClosedLoop, startsWithItsBackToTheRoute) {
  LoopOptions options = at(0.12, 0.25);
  options.start = Pose{paperRoute().vertices[0], Radians{-1.6}};
  const LoopResult r = report("start with its back to it", "look-ahead", paperRoute(), options);
  EXPECT_TRUE(r.finished);
  EXPECT_LT(r.crossTrackRms, 0.015);
}

TEST(ClosedLoop, turnsRoundOnTheSpotWhereTheRouteGoesBack) {
  const LoopResult r = report("there and back", "look-ahead", routeOf({{0, 0}, {1, 0}, {0, 0}}), at(0.20, 0.25));
  EXPECT_TRUE(r.finished);
  EXPECT_LT(r.endError, 0.02);
  EXPECT_LT(r.crossTrackRms, 0.015);
}

TEST(ClosedLoop, followsLegsShorterThanItsLookAhead) {
  const auto stairs = routeOf({{0, 0}, {0.1, 0}, {0.1, 0.1}, {0.2, 0.1}, {0.2, 0.2}, {0.3, 0.2}, {0.3, 0.3}, {1, 0.3}});
  const LoopResult r = report("stairs of 10 cm", "look-ahead", stairs, at(0.20, 0.25));
  EXPECT_TRUE(r.finished);
  EXPECT_LT(r.crossTrackRms, 0.015);
  EXPECT_LT(r.largestLoss, 0.02);
}

TEST(ClosedLoop, doesNotStopWhereTheRouteBendsALittle) {
  floor::Route arc;
  for (int i = 0; i <= 12; ++i) {
    const Radians a = fromDegrees(10.0 * i);
    arc.vertices.push_back({Metres{cos(a)}, Metres{sin(a)}});
  }
  const LoopResult r = report("arc of 1 m radius", "look-ahead", arc, at(0.20, 0.25));
  EXPECT_TRUE(r.finished);
  EXPECT_LT(r.crossTrackRms, 0.02);
  EXPECT_THAT(r.phases, ::testing::ElementsAre(Phase::OnLeg, Phase::Finished));
}

TEST(ClosedLoop, goesOnToTheEndWhereItHasStoppedShort) {
  // One that brakes harder than expected stops before it; standing, it sees that.
  for (const double delay : {0.1, 0.25, 0.75}) {
    for (const double acceleration : {0.5, 1.5}) {
      LoopOptions options = at(0.12, delay);
      options.period = delay / 2;
      options.acceleration = acceleration;
      options.poseNoise = 1e-4;
      const LoopResult r = report("straight on", "look-ahead", routeOf({{0, 0}, {1, 0}}), options);
      EXPECT_TRUE(r.finished) << delay;
      EXPECT_LT(r.endError, 0.005) << delay;
      EXPECT_GE(r.lowestCommand, 0.0);
    }
  }
}

TEST(ClosedLoop, doesNotConfuseNeighbouringLegs) {
  const auto comb = routeOf({{0, 0}, {1, 0}, {1, 0.06}, {0, 0.06}, {0, 0.12}, {1, 0.12}});
  const LoopResult r = report("legs 6 cm apart", "look-ahead", comb, at(0.12, 0.25));
  EXPECT_TRUE(r.finished);
  EXPECT_GT(r.duration, 3.0 / 0.12) << "it must not have jumped to a later leg";
  EXPECT_LT(r.endError, 0.02);
}

TEST(ClosedLoop, goesBackToTheRouteAfterBeingCarried) {
  LoopOptions options = at(0.12, 0.25);
  options.carryAt = 6.0;
  const LoopResult r = report("carried by 60 cm", "look-ahead", routeOf({{0, 0}, {0, 1.5}, {1, 1.5}}), options);
  EXPECT_TRUE(r.finished);
  EXPECT_LT(r.endError, 0.02);
  EXPECT_THAT(r.phases, ::testing::Contains(Phase::Approaching));
}

TEST(ClosedLoop, comesBackToTheLineAfterAPush) {
  const auto route = routeOf({{0, 0}, {0, 1.5}, {1, 1.5}});
  for (const double delay : {0.25, 0.75}) {
    const LoopResult alone = closeLoop("look-ahead", route, at(0.12, delay));
    LoopOptions options = at(0.12, delay);
    options.carryAt = 6.0;
    options.carryBy = 0.2;
    const LoopResult r = report("pushed by 20 cm", "look-ahead", route, options);
    EXPECT_TRUE(r.finished);
    EXPECT_LT(r.endError, 0.02);
    EXPECT_EQ(r.largestLoss, alone.largestLoss) << "it does not turn back for the line";
    EXPECT_LT(r.missedVertex, 0.02) << "it is on the line again where that bends, half a metre on";
    EXPECT_LT(r.duration, alone.duration + 5.0);
  }
}

TEST(ClosedLoop, isTheSameEveryTime) {
  LoopOptions options = at(0.12, 0.4);
  options.poseNoise = 0.01;
  options.jitter = 0.3;
  const LoopResult a = closeLoop("look-ahead", paperRoute(), options);
  const LoopResult b = closeLoop("look-ahead", paperRoute(), options);
  EXPECT_EQ(a.crossTrackRms, b.crossTrackRms);
  EXPECT_EQ(a.duration, b.duration);
}

}  // namespace
}  // namespace tessera::test
