// The controllers' parts: control points, prediction, speed plan, what is refused, what is said.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

#include "drive/closed_loop.h"
#include "drive/control_points.h"
#include "drive/route_follower.h"
#include "drive/stretch_limits.h"

namespace tessera::drive {
namespace {

using test::paperRoute;

Polyline line(std::initializer_list<std::pair<double, double>> places) {
  std::vector<Point> vertices;
  for (const auto& [x, y] : places) vertices.push_back({Metres{x}, Metres{y}});
  return Polyline{vertices};
}

std::vector<double> alongOf(const std::vector<ControlPoint>& points) {
  std::vector<double> along;
  for (const ControlPoint& p : points) along.push_back(std::round(1e6 * p.along.value()) / 1e6);
  return along;
}

TEST(ControlPoints, standEveryTwentyCentimetresOnThePapersRouteAndOnEachVertex) {
  const auto points = controlPoints(Polyline{paperRoute().vertices}, Metres{0.20}).value();
  // Legs of 1.2, 0.6, 1.2, 0.6 and 1.2 m.
  ASSERT_EQ(points.size(), 1U + 6 + 3 + 6 + 3 + 6);
  EXPECT_EQ(points[7].place.x.value(), 0.3 + 0.2) << "vertical legs are no special case";
  EXPECT_EQ(points[6].place, (Point{Metres{0.3}, Metres{1.5}}));
  EXPECT_TRUE(points[6].vertex);
  EXPECT_FALSE(points[5].vertex);
}

TEST(ControlPoints, mergeAShortRestAndKeepALongerOne) {
  EXPECT_THAT(alongOf(controlPoints(line({{0, 0}, {0.44, 0}}), Metres{0.2}).value()),
              testing::ElementsAre(0, 0.2, 0.44));
  EXPECT_THAT(alongOf(controlPoints(line({{0, 0}, {0.46, 0}}), Metres{0.2}).value()),
              testing::ElementsAre(0, 0.2, 0.4, 0.46));
  EXPECT_THAT(alongOf(controlPoints(line({{0, 0}, {0.03, 0}}), Metres{0.2}).value()), testing::ElementsAre(0, 0.03));
}

TEST(ControlPoints, refuseWhatMakesNoSense) {
  EXPECT_FALSE(controlPoints(line({{0, 0}}), Metres{0.2}));
  EXPECT_FALSE(controlPoints(line({{0, 0}, {1, 0}}), Metres{0.0}));
  EXPECT_FALSE(controlPoints(line({{0, 0}, {1, 0}}), Metres{std::nan("")}));
  EXPECT_FALSE(controlPoints(line({{0, 0}, {1e9, 0}}), Metres{0.01}));
}

VehicleState standing() { return {Seconds{10.0}, {}, MetresPerSecond{0.0}, RadiansPerSecond{0.0}, Metres{0.01}, true}; }
Command go(double speed, double heading) { return {MetresPerSecond{speed}, Radians{heading}}; }

TEST(Predictor, keepsStillWithoutCommandsAndBrakesWhenOneExpires) {
  VehicleState s = standing();
  EXPECT_EQ(predict(s, {}, Seconds{12.0}, {}).pose, s.pose);
  s.speed = MetresPerSecond{0.2};
  const std::vector<TimedCommand> expired{{go(0.2, 0.0), Seconds{9.0}, Seconds{10.0}}};
  const VehicleState e = predict(s, expired, Seconds{12.0}, {});
  EXPECT_NEAR(e.speed.value(), 0.0, 1e-6);
  EXPECT_NEAR(e.pose.position.x.value(), 0.2 * 0.2 / (2 * 3 * 0.5) + 0.2 * 0.03, 0.005)
      << "v²/2a, thrice as hard as usual, and the wheels' lag";
}

TEST(Predictor, rollsThroughTheCommandsInTheirOrder) {
  VehicleState s = standing();
  s.speed = MetresPerSecond{0.2};
  const std::vector<TimedCommand> commands{{go(0.2, 0.0), Seconds{9.0}, Seconds{11.0}},
                                           {go(0.2, kPi / 2), Seconds{11.0}, Seconds{14.0}}};
  EXPECT_NEAR(predict(s, commands, Seconds{11.0}, {}).pose.position.x.value(), 0.2, 1e-3);
  const VehicleState e = predict(s, commands, Seconds{14.0}, {});
  EXPECT_NEAR(e.pose.heading.value(), kPi / 2, 0.02);
  EXPECT_GT(e.pose.position.y.value(), 0.3) << "of 0.6 m, as it stands to turn and speeds up again";
  EXPECT_GT(e.sigma, s.sigma);
}

TEST(Predictor, neverGoesBackInTimeNorRollsForEver) {
  const VehicleState s = standing();
  EXPECT_EQ(predict(s, {}, Seconds{3.0}, {}).at, s.at);
  EXPECT_EQ(predict(s, {}, Seconds{1e9}, {}).at, Seconds{15.0});
  EXPECT_EQ(predict(s, {}, Seconds{std::nan("")}, {}).pose, s.pose);
}

TEST(SpeedPlan, saysTheStrictestReason) {
  SpeedPlanOptions options;
  options.requested = MetresPerSecond{0.2};
  const SpeedPlan plan{VehicleAbility{}, options};
  const SpeedPlan::Situation free{Metres{2.0}, false, Seconds{0.2}, Metres{0.01}, Radians{0.0}};
  EXPECT_EQ(plan.at(free).speed, MetresPerSecond{0.2});
  EXPECT_EQ(plan.at(free).reason, SpeedReason::Requested);
  auto s = free;
  s.toStop = Metres{0.03};
  EXPECT_EQ(plan.at(s).reason, SpeedReason::Corner);
  EXPECT_LT(plan.at(s).speed, MetresPerSecond{0.12});
  s.stopIsEnd = true;
  EXPECT_EQ(plan.at(s).reason, SpeedReason::End);
  s = free;
  s.delay = Seconds{2.0};
  EXPECT_EQ(plan.at(s).reason, SpeedReason::Delay);
  EXPECT_NEAR(plan.at(s).speed.value(), 0.25 * 0.60 / 2.0, 1e-9) << "0.25·L/T";
  s = free;
  s.sigma = Metres{0.10};
  EXPECT_EQ(plan.at(s).reason, SpeedReason::Uncertainty);
  s = free;
  s.headingSigma = Radians{0.5};
  EXPECT_EQ(plan.at(s).reason, SpeedReason::Uncertainty);
  EXPECT_NEAR(plan.at(s).speed.value(), 0.2 * options.leastByHeading, 1e-9) << "only driving teaches it its heading";
  s = free;
  s.headingError = Radians{0.8};
  EXPECT_EQ(plan.at(s).reason, SpeedReason::Heading);
}

TEST(SpeedPlan, takesCareBeforeTheEndWhereThePlaceIsNotWellKnown) {
  SpeedPlanOptions options;
  options.requested = MetresPerSecond{0.2};
  const SpeedPlan plan{VehicleAbility{}, options};
  SpeedPlan::Situation s{Metres{0.07}, true, Seconds{0.2}, Metres{0.01}, Radians{0.0}};
  EXPECT_EQ(plan.at(s).speed, options.endSpeed);
  EXPECT_EQ(plan.at(s).reason, SpeedReason::End);
  s.sigma = Metres{};
  EXPECT_GT(plan.at(s).speed, 2.0 * options.endSpeed);
  s.sigma = Metres{0.01};
  s.stopIsEnd = false;
  EXPECT_GT(plan.at(s).speed, 2.0 * options.endSpeed) << "a corner is only driven through";
}

TEST(StretchLimits, holdWhereTheVehicleMayBeAndSlowItDownBefore) {
  floor::Route route{"r", {{}, {Metres{1}, {}}, {Metres{2}, {}}, {Metres{3}, {}}}, Metres{0.2}};
  route.legSpeeds = {std::nullopt, MetresPerSecond{0.1}, std::nullopt};
  SpeedPlanOptions options;
  options.requested = MetresPerSecond{0.4};
  const SpeedPlan plan{VehicleAbility{}, options};
  const StretchLimits legs = StretchLimits::ofLegs(route);
  const auto at = [&](double x, double doubt = 0.0) { return legs.at(Metres{x}, Metres{doubt}, Seconds{0.2}, plan); };
  EXPECT_GT(at(0.1).speed, options.requested) << "far away";
  EXPECT_EQ(at(1.0).speed, MetresPerSecond{0.1});
  EXPECT_EQ(at(1.9).reason, SpeedReason::Leg);
  EXPECT_GT(at(2.0).speed, options.requested) << "behind it";
  EXPECT_EQ(at(0.98, 0.05).speed, MetresPerSecond{0.1}) << "it may be on it already";
  EXPECT_EQ(at(2.03, 0.05).speed, MetresPerSecond{0.1}) << "it may be on it still";
  EXPECT_EQ(at(0.9).reason, SpeedReason::SlowerLeg);
  const double v = at(0.9).speed.value();
  EXPECT_NEAR(v * 0.2 + (v * v - 0.01) / (2 * 0.25), 0.08, 1e-6) << "held for the delay, then braked off";
  EXPECT_EQ(legs.at(Metres{1.9}, {}, Seconds{0.2}, plan, Metres{2}).speed, StretchLimits{}.at({}, {}, {}, plan).speed)
      << "a leg that is not driven at all";
}

TEST(SpeedPlan, lookAheadGrowsWithSpeedAndDelay) {
  const VehicleAbility ability;
  const SpeedPlanOptions options;
  EXPECT_EQ(lookAhead(MetresPerSecond{0.01}, Seconds{0.1}, ability, options), options.shortestLook);
  EXPECT_NEAR(lookAhead(MetresPerSecond{0.2}, Seconds{0.5}, ability, options).value(), 0.4, 1e-9);
  EXPECT_EQ(lookAhead(MetresPerSecond{0.5}, Seconds{5.0}, ability, options), options.longestLook);
}

FollowerSetup setupOf(const floor::Route& route, double speed = 0.12) {
  FollowerSetup setup{route, {}, {}};
  setup.plan.requested = MetresPerSecond{speed};
  return setup;
}

TEST(RouteFollower, refusesWhatCannotBeDriven) {
  for (const std::string_view name : followerNames()) {
    floor::Route route = paperRoute();
    EXPECT_EQ((*makeRouteFollower(name, setupOf(route)))->name(), name);
    EXPECT_FALSE(makeRouteFollower(name, setupOf(route, 0.0)));
    EXPECT_FALSE(makeRouteFollower(name, setupOf(route, std::nan(""))));
    const auto fast = makeRouteFollower(name, setupOf(route, 0.9));
    ASSERT_FALSE(fast);
    EXPECT_EQ(fast.error().sentence,
              "A speed of 0.9 m/s cannot be asked for: the vehicle drives more than 0 and up to 0.5 m/s.");
    route.vertices[1].x = Metres{std::nan("")};
    EXPECT_FALSE(makeRouteFollower(name, setupOf(route)));
    route.vertices.resize(1);
    EXPECT_FALSE(makeRouteFollower(name, setupOf(route)));
  }
  EXPECT_FALSE(makeRouteFollower("autopilot", setupOf(paperRoute())));
}

PredictedState seen(double x, double y, double heading, bool located = true) {
  VehicleState s;
  s.pose = {{Metres{x}, Metres{y}}, Radians{heading}};
  s.located = located;
  return {s, Seconds{0.2}};
}

TEST(RouteFollower, standsStillWhileThePlaceIsUnknownAndGoesOnAfterwards) {
  const auto follower = makeRouteFollower("look-ahead", setupOf(paperRoute())).value();
  const Decision lost = follower->decide(seen(0.3, 0.5, kPi / 2, false), Seconds{0.0});
  EXPECT_EQ(lost.phase, Phase::Lost);
  EXPECT_EQ(lost.command.speed, MetresPerSecond{0.0});
  EXPECT_EQ(lost.command.heading, Radians{kPi / 2}) << "it does not turn either";
  const Decision nan = follower->decide(seen(std::nan(""), 0.5, 0.0), Seconds{0.1});
  EXPECT_EQ(nan.phase, Phase::Lost);
  EXPECT_TRUE(std::isfinite(nan.command.heading.value()));
  EXPECT_EQ(follower->decide(seen(0.3, 0.3, kPi / 2), Seconds{0.2}).phase, Phase::OnLeg);
}

TEST(RouteFollower, saysWhatItDoesInASentence) {
  const floor::Route route = paperRoute();
  const Polyline polyline{route.vertices};
  const auto follower = makeRouteFollower("look-ahead", setupOf(route)).value();
  const Decision on = follower->decide(seen(0.3, 0.35, kPi / 2), Seconds{0.0});
  EXPECT_EQ(sentence(follower->decide(seen(0.3, 0.35, 0.0, false), Seconds{0.0}), polyline),
            "Standing still, because its place is unknown.");
  EXPECT_EQ(on.phase, Phase::Approaching);
  const auto started = makeRouteFollower("look-ahead", setupOf(route)).value();
  EXPECT_EQ(sentence(started->decide(seen(0.3, 0.31, kPi / 2), Seconds{0.0}), polyline),
            "On leg 1 of 5, 4.79 m to go: 0.12 m/s, as asked for.");
  EXPECT_EQ(sentence(started->decide(seen(0.3, 0.31, 0.0), Seconds{0.1}), polyline),
            "Turning on the spot by 90° to leg 1 of 5.");
}

TEST(RouteFollower, progressNeverFallsAndCommandsStaySoundUnderRandomPoses) {
  for (const std::string_view name : followerNames()) {
    for (std::uint32_t seed = 1; seed <= 50; ++seed) {
      std::mt19937 random{seed};
      std::uniform_real_distribution<double> unit;
      const auto follower = makeRouteFollower(name, setupOf(paperRoute())).value();
      Metres best{};
      for (int i = 0; i < 400; ++i) {
        PredictedState p = seen(1.8 * unit(random), 1.8 * unit(random), 7 * unit(random) - 3.5, unit(random) > 0.1);
        p.delay = Seconds{unit(random) < 0.05 ? std::nan("") : 2 * unit(random)};
        p.state.sigma = Metres{0.2 * unit(random)};
        const Decision d = follower->decide(p, Seconds{0.1 * i});
        ASSERT_TRUE(std::isfinite(d.command.speed.value()) && std::isfinite(d.command.heading.value()));
        ASSERT_GE(d.command.speed, MetresPerSecond{0.0});
        ASSERT_LE(d.command.speed, MetresPerSecond{0.12});
        ASSERT_LE(d.progress, follower->route().length() + Metres{1e-9});
        if (name == "look-ahead") {
          ASSERT_GE(d.progress + Metres{1e-9}, best) << "seed " << seed;
        }
        best = std::max(best, d.progress);
      }
    }
  }
}

}  // namespace
}  // namespace tessera::drive
