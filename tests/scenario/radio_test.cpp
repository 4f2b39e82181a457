// A bad radio, and a key that is not the vehicle's: whole runs in virtual time.
#include <gmock/gmock.h>

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
