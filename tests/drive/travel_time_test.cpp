// The time foretold against the time that the controller takes in its closed loop.
#include "drive/travel_time.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "base/polyline.h"
#include "drive/closed_loop.h"
#include "floor/route_legs.h"

namespace tessera::test {
namespace {

double foretold(const floor::Route& route, double speed, double delay, double cut = 0.0) {
  drive::SpeedPlanOptions plan;
  plan.requested = MetresPerSecond{speed};
  drive::VehicleAbility ability;
  ability.cornerCut = Metres{cut};
  return drive::travelTime(route, ability, plan, Seconds{delay}).value();
}

floor::Route zigzag(int legs, double turn) {
  floor::Route route{"zigzag", {{}}, Metres{0.2}};
  for (int n = 0; n < legs; ++n)
    route.vertices.push_back(route.vertices.back() + turned({Metres{0.8}, {}}, Radians{n % 2 == 0 ? 0.0 : turn}));
  return route;
}

TEST(TravelTime, isWhatTheClosedLoopTakes) {
  for (const floor::Route& route : {paperRoute(), zigzag(6, 1.5708), zigzag(6, 0.3), zigzag(1, 0.0)}) {
    for (const double speed : {0.05, 0.12, 0.30}) {
      LoopOptions options;
      options.speed = speed;
      const LoopResult driven = closeLoop("look-ahead", route, options);
      ASSERT_TRUE(driven.finished) << route.name;
      const double expected = foretold(route, speed, options.up + options.period);
      std::printf("%-8s %2zu legs at %.2f m/s: %.1f s foretold, %.1f s driven\n", route.name.c_str(),
                  route.vertices.size() - 1, speed, expected, driven.duration);
      EXPECT_NEAR(expected, driven.duration, 0.08 * driven.duration + 0.5);
    }
  }
}

TEST(TravelTime, isWhatTheClosedLoopTakesRoundArcs) {
  for (const floor::Route& route : {paperRoute(), zigzag(6, 1.5708), zigzag(6, 2.3)}) {
    for (const double speed : {0.05, 0.12, 0.30}) {
      for (const double cut : {0.03, 0.05, 0.15}) {
        LoopOptions options;
        options.speed = speed;
        options.cut = cut;
        const LoopResult driven = closeLoop("look-ahead", route, options);
        ASSERT_TRUE(driven.finished) << route.name;
        const double expected = foretold(route, speed, options.up + options.period, cut);
        std::printf("%-8s %2zu legs, cut %.2f m, at %.2f m/s: %.1f s foretold, %.1f s driven\n", route.name.c_str(),
                    route.vertices.size() - 1, cut, speed, expected, driven.duration);
        // The vehicle is faster where an arc begins than it is while it turns.
        EXPECT_NEAR(expected, driven.duration, 0.12 * driven.duration + 0.5);
      }
    }
  }
}

TEST(TravelTime, reckonsWithTheSpeedsOfLegs) {
  floor::Route route = zigzag(6, 0.3);
  const double free = foretold(route, 0.3, 0.225);
  floor::setLegSpeed(route, 1, MetresPerSecond{0.05});
  floor::setLegSpeed(route, 4, MetresPerSecond{0.10});
  LoopOptions options;
  options.speed = 0.3;
  const LoopResult driven = closeLoop("look-ahead", route, options);
  ASSERT_TRUE(driven.finished);
  const double expected = foretold(route, 0.3, options.up + options.period);
  std::printf("two slow legs: %.1f s foretold, %.1f s driven, %.1f s without\n", expected, driven.duration, free);
  EXPECT_NEAR(expected, driven.duration, 0.05 * driven.duration + 0.5);
  EXPECT_GT(expected, free + 0.8 / 0.05 + 0.8 / 0.10 - 2 * 0.8 / 0.3);
}

TEST(TravelTime, isNoShorterThanAtFullSpeedAllTheWay) {
  const floor::Route route = zigzag(5, 1.0);
  EXPECT_GT(foretold(route, 0.2, 0.2), Polyline{route.vertices}.length().value() / 0.2);
  EXPECT_LT(foretold(route, 0.2, 0.2), foretold(route, 0.1, 0.2));
}

TEST(TravelTime, bearsRoutesThatAreNone) {
  EXPECT_EQ(foretold({"", {}, Metres{0.2}}, 0.2, 0.2), 0.0);
  EXPECT_EQ(foretold({"", {{}, {}}, Metres{0.2}}, 0.2, 0.2), 0.0);
  const floor::Route far{"", {{Metres{-1e5}, {}}, {Metres{1e5}, {}}}, Metres{0.2}};
  EXPECT_NEAR(foretold(far, 0.2, 0.2), 1e6, 1e4);
}

}  // namespace
}  // namespace tessera::test
