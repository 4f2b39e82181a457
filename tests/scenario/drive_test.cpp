// The main job from end to end: vehicles drive routes on a tile floor, led over a slow radio.
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
