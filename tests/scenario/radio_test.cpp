// A bad radio, and a key that is not the vehicle's: whole runs in virtual time.
#include <gmock/gmock.h>

#include <cmath>

#include "scenario/scenario.h"

namespace tessera::scenario {
namespace {

using supervisor::EventKind;

TEST(LostPackets, slowTheDriveDownButDoNotEndIt) {
  ScenarioSetup setup;
  setup.world.drop = 0.2;
  Scenario scenario{setup};
  scenario.orderRoutes();
  EXPECT_TRUE(scenario.until(Seconds{300}, [&] { return scenario.finished(); })) << scenario.sentences();
  EXPECT_EQ(scenario.outcomes().front().metrics.reversals, 0);
}

class ALinkWithDelay : public testing::TestWithParam<double> {};

// The delay is the same on both ways here, which no host can know: see decision 0005.
TEST_P(ALinkWithDelay, doesNotMoveTheEstimateAlongTheWay) {
  ScenarioSetup setup;
  setup.world.airFactor = 1.0;
  setup.world.delay = GetParam();
  Scenario scenario{setup};
  scenario.orderRoutes();
  double along = 0.0;
  int samples = 0;
  const auto watch = [&] {
    const auto truth = scenario.world().truth(VehicleId{1});
    if (truth && truth->speed > MetresPerSecond{0.1} && scenario.view().progress > Metres{0.3}) {
      const Offset off = scenario.view().pose.position - truth->pose.position;
      along +=
          off.x.value() * std::cos(truth->pose.heading.value()) + off.y.value() * std::sin(truth->pose.heading.value());
      ++samples;
    }
    return scenario.finished();
  };
  ASSERT_TRUE(scenario.until(Seconds{300}, watch)) << scenario.sentences();
  ASSERT_GT(samples, 1000);
  RecordProperty("along_cm", std::to_string(100 * along / samples));
  EXPECT_LT(std::abs(along / samples), 0.008);
  EXPECT_NEAR(scenario.lockstep().snapshot()->channel.delay.value(), GetParam(), 0.006);
  const auto metrics = scenario.outcomes().front().metrics;
  EXPECT_LT(metrics.positionErrorMean.value(), 0.02);
  EXPECT_LT(metrics.crossTrackRms.value(), 0.04);
  EXPECT_EQ(metrics.reversals, 0);
  EXPECT_EQ(scenario.eventCount(EventKind::Silent), 0U) << scenario.sentences();
}

INSTANTIATE_TEST_SUITE_P(Seconds, ALinkWithDelay, testing::Values(0.05, 0.3, 0.5));

// Calls are repeated faster than answers come; seeds 2, 3 and 5 once never met their vehicle for that.
TEST(ALinkWithALongDelay, isConnectedAndDrivenWhateverTheSeed) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    ScenarioSetup setup;
    setup.seed = seed;
    setup.world.delay = 1.0;
    Scenario scenario{setup};
    ASSERT_TRUE(scenario.until(Seconds{15}, [&] { return scenario.eventCount(EventKind::Identified) > 0; })) << seed;
    scenario.orderRoutes();
    EXPECT_TRUE(scenario.until(Seconds{60}, [&] { return scenario.view().progress > Metres{1.0}; }))
        << seed << scenario.sentences();
  }
}

TEST(AWrongKey, isToldAndTheVehicleStaysWhereItIs) {
  ScenarioSetup setup;
  setup.wrongKey = true;
  Scenario scenario{setup};
  EXPECT_TRUE(scenario.until(Seconds{30}, [&] { return scenario.eventCount(EventKind::WrongKey) > 0; }))
      << scenario.sentences();
  scenario.supervisor().post(supervisor::RunRoute{VehicleId{1}, "paper", MetresPerSecond{0.12}});
  scenario.go(Seconds{10});
  EXPECT_LT(abs(scenario.trueSpeed()), MetresPerSecond{0.005});
}

}  // namespace
}  // namespace tessera::scenario
