// The main job from end to end: vehicles drive routes on a tile floor, led over a slow radio.
#include <algorithm>

#include "base/polyline.h"
#include "floor/route_legs.h"
#include "scenario/scenario.h"

namespace tessera::scenario {
namespace {

class PaperRoute : public testing::TestWithParam<double> {};

TEST_P(PaperRoute, isDrivenToItsEndOnTheLineWithoutTurningBack) {
  ScenarioSetup setup;
  setup.speed = MetresPerSecond{GetParam()};
  Scenario scenario{setup};
  scenario.orderRoutes();
  ASSERT_TRUE(scenario.until(Seconds{300}, [&] { return scenario.finished(); })) << scenario.sentences();
  const auto metrics = scenario.outcomes().front().metrics;
  RecordProperty("position_error_mean_cm", std::to_string(metrics.positionErrorMean.value() * 100));
  EXPECT_LT(metrics.positionErrorMean.value(), 0.05);
  EXPECT_LT(metrics.crossTrackRms.value(), 0.03);
  EXPECT_EQ(metrics.reversals, 0);
  EXPECT_GE(metrics.meanSpeedRatio, 0.8);
}

INSTANTIATE_TEST_SUITE_P(Speeds, PaperRoute, testing::Values(0.05, 0.08, 0.12, 0.20));

class UnequalTyres : public testing::TestWithParam<double> {};

TEST_P(UnequalTyres, keepNoVehicleFromItsRoute) {
  ScenarioSetup setup;
  setup.speed = MetresPerSecond{0.20};
  setup.world.tyreDifference = GetParam();
  Scenario scenario{setup};
  scenario.orderRoutes();
  ASSERT_TRUE(scenario.until(Seconds{300}, [&] { return scenario.finished(); })) << scenario.sentences();
  const auto metrics = scenario.outcomes().front().metrics;
  RecordProperty("cross_track_rms_cm", std::to_string(metrics.crossTrackRms.value() * 100));
  EXPECT_LT(metrics.positionErrorMean.value(), 0.05);
  EXPECT_LT(metrics.crossTrackRms.value(), 0.03);
  EXPECT_EQ(metrics.reversals, 0);
}

INSTANTIATE_TEST_SUITE_P(Shares, UnequalTyres, testing::Values(-0.10, -0.03, 0.03, 0.10));

TEST(ASlowLeg, isDrivenNoFasterThanItMayAndTheOthersAsOrdered) {
  static constexpr MetresPerSecond kSlow{0.06};
  static constexpr std::size_t kSlowLeg = 1;  // begins and ends on a straight way: nothing else slows it down there
  Polyline line;
  ScenarioSetup setup;
  setup.speed = MetresPerSecond{0.20};
  setup.change = [&line](floor::Site& site) {
    floor::Route& route = site.routes.front();
    insertVertex(route, 1, {Metres{0.3}, Metres{0.7}});
    insertVertex(route, 2, {Metres{0.3}, Metres{1.1}});
    setLegSpeed(route, kSlowLeg, kSlow);
    line = Polyline{route.vertices};
  };
  Scenario scenario{setup};
  scenario.orderRoutes();
  std::vector<double> top(line.legCount(), 0.0);
  Metres reached;
  const auto watch = [&] {
    const auto truth = scenario.world().truth(VehicleId{1});
    if (!truth) return true;
    const auto on = line.project(truth->pose.position, reached - Metres{0.1}, reached + Metres{0.2});
    reached = std::max(reached, on.along);
    double& most = top[line.legAt(on.along)];
    most = std::max(most, truth->speed.value());
    return scenario.finished();
  };
  ASSERT_TRUE(scenario.until(Seconds{300}, watch)) << scenario.sentences();
  ASSERT_TRUE(scenario.finished());
  for (std::size_t leg = 0; leg < top.size(); ++leg) {
    RecordProperty("top_speed_cm_s_leg_" + std::to_string(leg + 1), std::to_string(top[leg] * 100));
    if (leg == kSlowLeg) {
      EXPECT_LE(top[leg], kSlow.value() + 0.015) << "but for what its speed control overshoots";
      EXPECT_GE(top[leg], kSlow.value() - 0.01) << "no slower than it has to be";
    } else {
      EXPECT_GE(top[leg], 0.15) << "leg " << leg + 1;
    }
  }
}

TEST(ThreeVehicles, driveTheirRoutesAtOnceOnOneChannel) {
  ScenarioSetup setup;
  setup.site = "three.tessera.json";
  setup.assignments = {{VehicleId{1}, "one"}, {VehicleId{2}, "two"}, {VehicleId{3}, "three"}};
  Scenario scenario{setup};
  scenario.orderRoutes();
  ASSERT_TRUE(scenario.until(Seconds{400}, [&] { return scenario.finished(); })) << scenario.sentences();
  for (const auto& outcome : scenario.outcomes()) {
    EXPECT_LT(outcome.metrics.positionErrorMean.value(), 0.05) << outcome.name;
    EXPECT_LT(outcome.metrics.crossTrackRms.value(), 0.03) << outcome.name;
    EXPECT_EQ(outcome.metrics.reversals, 0) << outcome.name;
  }
}

TEST(TheSameSeed, givesTheSameRun) {
  const auto drive = [] {
    Scenario scenario{ScenarioSetup{}};
    scenario.orderRoutes();
    scenario.go(Seconds{10});
    return std::pair{scenario.view().pose, scenario.sentences()};
  };
  EXPECT_EQ(drive(), drive());
}

}  // namespace
}  // namespace tessera::scenario
