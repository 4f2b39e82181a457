// Vehicles on a floor with iron: what the first have learned helps the next.
#include <cmath>

#include "locate/magnetic_map.h"
#include "scenario/scenario.h"

namespace tessera::scenario {
namespace {

constexpr VehicleId kFirst{1};
constexpr VehicleId kSecond{2};
constexpr Offset kAway{Metres{30.0}, Metres{30.0}};

/// Both vehicles in turn on the same route of the publication's floor, over the same iron; the other one is out of the
/// way meanwhile, carried back while it stands.
struct OneAfterTheOther {
  OneAfterTheOther() {
    setup.world.compassSpots = 20.0;
    setup.assignments = {{kFirst, "paper"}, {kSecond, "paper"}};
    setup.change = [](floor::Site& site) {
      floor::VehicleSetup other = site.vehicles.front();
      other.id = kSecond;
      other.name = "second";
      other.key[0] ^= 0x5A;
      site.vehicles = {site.vehicles.front(), other};
    };
    scenario = std::make_unique<Scenario>(setup);
    scenario->world().push(kSecond, kAway, {});
    EXPECT_TRUE(scenario->until(Seconds{30}, [&] { return scenario->recorder().allConnected(); }));
    drive(kFirst, 0);
    const Offset back{-kAway.x, -kAway.y};
    scenario->world().push(kFirst, kAway, {});
    scenario->world().push(kSecond, back, {});
    scenario->go(Seconds{10});
    drive(kSecond, 1);
  }
  void drive(VehicleId who, std::size_t assignment) {
    scenario->supervisor().post(supervisor::RunRoute{who, "paper", setup.speed});
    EXPECT_TRUE(scenario->until(Seconds{200}, [&] { return scenario->view(assignment).finished; }))
        << scenario->sentences();
  }

  ScenarioSetup setup;
  std::unique_ptr<Scenario> scenario;
};

using Learned = std::shared_ptr<const locate::MagneticMap>;
struct Drive {
  double headingError = 0.0;  ///< RMS, rad
  Learned map;
};
/// Another vehicle for each seed, on the floor's iron, with what others have learned of it; located by that if asked.
Drive driveOver(std::uint64_t floor, std::uint64_t seed, const Learned& before, bool byMap) {
  ScenarioSetup setup;
  setup.seed = seed;
  setup.world.floorSeed = floor;
  setup.world.compassSpots = 20.0;
  setup.byMagneticMap = byMap;
  Scenario scenario{setup};
  if (before) scenario.supervisor().post(supervisor::UseMagneticMap{before});
  scenario.orderRoutes();
  EXPECT_TRUE(scenario.until(Seconds{200}, [&] { return scenario.finished(); })) << scenario.sentences();
  return {scenario.outcomes().front().metrics.headingErrorRms.value(), scenario.lockstep().snapshot()->magnetic};
}

// Runs differ by a third of what is judged here, so it takes some floors to tell the map's gain from chance.
TEST(TheMagneticMap, letsAVehicleKnowItsHeadingBetterAfterOthersHaveDriven) {
  constexpr std::uint64_t kFloors = 6;
  constexpr std::uint64_t kBefore = 6;
  double without = 0.0;
  double with = 0.0;
  for (std::uint64_t floor = 1; floor <= kFloors; ++floor) {
    Learned learned;
    for (std::uint64_t i = 0; i < kBefore; ++i) learned = driveOver(floor, 100 * floor + i, learned, true).map;
    without += driveOver(floor, floor, nullptr, false).headingError / kFloors;
    with += driveOver(floor, floor, learned, true).headingError / kFloors;
  }
  RecordProperty("heading_rms_deg_without", std::to_string(without * 180 / kPi));
  RecordProperty("heading_rms_deg_with", std::to_string(with * 180 / kPi));
  EXPECT_LT(with, 0.9 * without);
}

TEST(TheMagneticMap, isLearnedWhetherVehiclesAreLocatedByItOrNot) {
  const OneAfterTheOther run;
  const auto& snapshot = run.scenario->lockstep().snapshot();
  ASSERT_NE(snapshot->magnetic, nullptr);
  EXPECT_GT(snapshot->magnetic->nodeCount(), 30U);
  const Point onRoute{Metres{0.3}, Metres{0.9}};
  EXPECT_GT(snapshot->magnetic->at(onRoute).known(), 0.3);
  EXPECT_GE(snapshot->magnetic->at(onRoute).visits, 2U) << "by both";
}

TEST(TheMagneticMap, isReplacedAndForgottenByOrder) {
  ScenarioSetup setup;
  Scenario scenario{setup};
  scenario.orderRoutes();
  scenario.go(Seconds{20});
  const auto learned = scenario.lockstep().snapshot()->magnetic;
  ASSERT_FALSE(learned->empty());
  scenario.supervisor().post(supervisor::UseMagneticMap{});
  scenario.go(Seconds{0.2});
  EXPECT_TRUE(scenario.lockstep().snapshot()->magnetic->empty());
  EXPECT_FALSE(learned->empty()) << "the picture that somebody holds stays";
  scenario.supervisor().post(supervisor::UseMagneticMap{learned});
  scenario.go(Seconds{0.2});
  EXPECT_EQ(scenario.lockstep().snapshot()->magnetic->nodeCount(), learned->nodeCount());
}

}  // namespace
}  // namespace tessera::scenario
