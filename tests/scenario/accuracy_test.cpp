// How well vehicles are located and led where every error of their sensors is given: the figures of docs/experiments.md
// in few seeds, so that nobody loses them unnoticed.
#include <cmath>

#include "scenario/scenario.h"

namespace tessera::scenario {
namespace {

constexpr int kDrives = 4;

struct Case {
  const char* name;
  double speed = 0.12;  // m/s
  double air = 19200;   // bit/s
  double airFactor = 1.8;
  double poll = 0.1;             // s
  double speedNoiseTime = 0.05;  // s; 0.5 wanders
  bool rough = false;            // a fifth of the reads lost, 5 degrees of bias, a tenth of the way slipped
  double spots = 10.0;           // degrees, by which iron in the floor turns the compass
  double cut = 0.0;              // m
  const char* locator = "";
  double mostError = 0.0;   // cm, mean
  double mostAcross = 0.0;  // cm, RMS off corners
  double mostAside = 0.0;   // cm, largest off corners; 0: not asked
};

ScenarioSetup setupOf(const Case& c, std::uint64_t seed) {
  ScenarioSetup setup;
  setup.seed = seed;
  setup.speed = MetresPerSecond{c.speed};
  setup.locator = c.locator;
  setup.change = [&c](floor::Site& site) {
    for (floor::VehicleSetup& vehicle : site.vehicles) vehicle.cornerCut = Metres{c.cut};
  };
  world::WorldOptions& world = setup.world;
  world.airRate = c.air;
  world.airFactor = c.airFactor;
  world.poll = c.poll;
  world.detection = c.rough ? 0.72 : 0.9;
  world.compassNoise = 2.0;
  world.compassBias = c.rough ? 5.0 : 2.0;
  world.compassSpots = c.spots;
  world.slip = c.rough ? 0.1 : 0.0;
  world.speedNoise = 0.1;
  world.speedNoiseTime = c.speedNoiseTime;
  return setup;
}

struct Means {
  double error = 0.0;   // cm
  double across = 0.0;  // cm, RMS off corners
  double aside = 0.0;   // cm, the largest of all
  double nees = 0.0;
  double ratio = 1.0;  // the least
};

void drive(const Case& c, Means& means) {
  for (int seed = 1; seed <= kDrives; ++seed) {
    Scenario scenario{setupOf(c, static_cast<std::uint64_t>(seed))};
    scenario.orderRoutes();
    ASSERT_TRUE(scenario.until(Seconds{300}, [&] { return scenario.finished(); })) << scenario.sentences();
    const auto metrics = scenario.outcomes().front().metrics;
    EXPECT_EQ(metrics.reversals, 0) << "seed " << seed;
    means.error += 100.0 * metrics.positionErrorMean.value() / kDrives;
    means.across += 100.0 * metrics.crossTrackRmsOffCorners.value() / kDrives;
    means.aside = std::max(means.aside, 100.0 * metrics.crossTrackMaxOffCorners.value());
    means.nees += metrics.consistency.neesMean / kDrives;
    means.ratio = std::min(means.ratio, metrics.meanSpeedRatio);
  }
}

class Accuracy : public testing::TestWithParam<Case> {};

TEST_P(Accuracy, isKept) {
  Means means;
  ASSERT_NO_FATAL_FAILURE(drive(GetParam(), means));
  RecordProperty("position_error_mean_cm", std::to_string(means.error));
  EXPECT_LT(means.error, GetParam().mostError);
  EXPECT_LT(means.across, GetParam().mostAcross);
  if (GetParam().mostAside > 0.0) {
    EXPECT_LT(means.aside, GetParam().mostAside);
  }
  EXPECT_GT(means.nees, 1.0) << "2 is honest";
  EXPECT_LT(means.nees, 3.0);
  // Arcs are driven as slowly as their corner wants it, 20 cm beside it as well.
  if (GetParam().cut == 0.0) {
    EXPECT_GE(means.ratio, GetParam().rough ? 0.72 : 0.8) << "it does not crawl; of rough rows a tenth is the slip";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Rows, Accuracy,
    testing::Values(
        Case{.name = "fastRadio", .mostError = 1.0, .mostAcross = 1.5},
        Case{.name = "slowRadio", .air = 2400, .airFactor = 1.0, .poll = 0.2, .mostError = 1.5, .mostAcross = 2.0},
        Case{.name = "rough",
             .air = 2400,
             .airFactor = 1.0,
             .poll = 0.2,
             .rough = true,
             .mostError = 2.0,
             .mostAcross = 2.0},
        Case{.name = "longDelay",
             .air = 2400,
             .airFactor = 1.0,
             .spots = 0.0,
             .mostError = 1.2,
             .mostAcross = 1.5,
             .mostAside = 4.0},
        Case{.name = "quick", .speed = 0.5, .mostError = 1.5, .mostAcross = 2.5},
        Case{.name = "roundedCornersOverASlowRadio", .air = 2400, .cut = 0.05, .mostError = 1.4, .mostAcross = 2.2}),
    [](const auto& one) { return std::string{one.param.name}; });

TEST(AccuracyOfTheLocator, isFourTimesThatOfTheTagsCentre) {
  Means ours;
  Means centre;
  ASSERT_NO_FATAL_FAILURE(drive({.name = "ours"}, ours));
  ASSERT_NO_FATAL_FAILURE(drive({.name = "centre", .locator = "tag-centre"}, centre));
  EXPECT_GT(centre.error, 4.0 * ours.error);
}

}  // namespace
}  // namespace tessera::scenario
