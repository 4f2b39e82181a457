#include "sim/plant.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tessera::sim {
namespace {

constexpr Seconds kMillisecond{0.001};
constexpr double kMotorVolts = 12.0;

PlantParameters perfect() {
  PlantParameters p;
  p.motorMismatch = p.scaleError = p.scaleDifference = p.slipWander = p.wayNoise = 0.0;
  return p;
}

Plant perfectPlant(const PlantParameters& parameters = perfect()) {
  return Plant{parameters, Pose{}, RandomStream{1, "plant"}};
}

void run(Plant& plant, int milliseconds, std::array<int, 2> duty) {
  for (int i = 0; i < milliseconds; ++i) plant.step(kMillisecond, duty, kMotorVolts);
}

TEST(Plant, followsTheClosedFormOfAnArc) {
  // A quarter circle to the left of radius 2 m, cut into pieces of any number, ends at (2, 2), heading up.
  for (const int pieces : {1, 2, 7, 1000}) {
    Pose pose;
    for (int i = 0; i < pieces; ++i) pose = advancedAlongArc(pose, Metres{kPi / pieces}, Radians{kPi / 2 / pieces});
    EXPECT_NEAR(pose.position.x.value(), 2.0, 1e-9) << pieces;
    EXPECT_NEAR(pose.position.y.value(), 2.0, 1e-9) << pieces;
    EXPECT_NEAR(pose.heading.value(), kPi / 2, 1e-9) << pieces;
  }
}

TEST(Plant, goesStraightOnWithoutATurn) {
  const Pose pose = advancedAlongArc({{Metres{1.0}, Metres{2.0}}, Radians{kPi / 2}}, Metres{0.5}, Radians{});
  EXPECT_NEAR(pose.position.x.value(), 1.0, 1e-12);
  EXPECT_NEAR(pose.position.y.value(), 2.5, 1e-12);
}

TEST(Plant, isLedAlongABendByTyresOfWhichItsEncodersTellNothing) {
  PlantParameters p = perfect();
  p.tyreDifference = 0.10;
  Plant plant = perfectPlant(p);
  EXPECT_NEAR(plant.trueDiameter(1) / plant.trueDiameter(0), 1.05 / 0.95, 1e-9);
  // Duties at which both wheels turn alike: what the left one lacks at its rim it has in turns.
  const double rim = 0.3;
  const auto duty = [](double speed) { return static_cast<int>(std::lround(1000.0 * (speed + 0.03) / 0.8)); };
  run(plant, 20'000, {duty(0.95 * rim), duty(1.05 * rim)});
  const auto counts = plant.encoderCounts();
  EXPECT_NEAR(static_cast<double>(counts[1]) / static_cast<double>(counts[0]), 1.0, 0.005);
  EXPECT_NEAR(plant.turnRate().value() / plant.speed().value(), 0.10 / 0.30, 0.01);
}

TEST(Plant, drivesACircleWhoseRadiusIsThatOfTheWheelSpeeds) {
  Plant plant = perfectPlant();
  run(plant, 2000, {400, 600});
  const double left = plant.speed().value() - plant.turnRate().value() * 0.15;
  const double right = plant.speed().value() + plant.turnRate().value() * 0.15;
  EXPECT_NEAR(left, 0.4 * 0.8 - 0.03, 1e-6);
  EXPECT_NEAR(right, 0.6 * 0.8 - 0.03, 1e-6);
  // From now on the path is a circle about a fixed centre.
  const double radius = plant.speed().value() / plant.turnRate().value();
  const Point centre = placeOf(plant.pose(), {Metres{}, Metres{radius}});
  for (int i = 0; i < 50; ++i) {
    run(plant, 97, {400, 600});
    EXPECT_NEAR(distance(plant.pose().position, centre).value(), radius, 1e-6);
  }
}

TEST(Plant, countsEncoderEdgesInProportionToTheWayWithoutSlip) {
  Plant plant = perfectPlant();
  run(plant, 5000, {500, 500});
  const double way = plant.pose().position.x.value();
  EXPECT_GT(way, 1.0);
  for (const std::int64_t counts : plant.encoderCounts())
    EXPECT_EQ(counts, static_cast<std::int64_t>(std::floor(way / (kPi * 0.10) * 200 + 1e-9)));
}

TEST(Plant, countsBackwards) {
  Plant plant = perfectPlant();
  run(plant, 3000, {-500, -500});
  EXPECT_LT(plant.pose().position.x.value(), -0.5);
  EXPECT_NEAR(static_cast<double>(plant.encoderCounts()[0]) / 200.0 * kPi * 0.10, plant.pose().position.x.value(),
              0.002);
}

TEST(Plant, losesTheSameShareOfItsWayBySlipAtAnySpeedButNoCounts) {
  PlantParameters parameters = perfect();
  parameters.slip = 0.2;
  for (const int duty : {200, 1000}) {
    Plant plant = perfectPlant(parameters);
    run(plant, 5000, {duty, duty});
    const double turned = plant.wheelAngle(0).value() * 0.05;
    ASSERT_GT(turned, 0.1);
    EXPECT_NEAR(plant.pose().position.x.value() / turned, 0.8, 1e-6) << duty;
  }
}

TEST(Plant, reachesTwoThirdsOfItsSpeedAfterOneLag) {
  Plant plant = perfectPlant();
  run(plant, 100, {500, 500});
  EXPECT_NEAR(plant.speed().value(), (1.0 - std::exp(-1.0)) * 0.37, 1e-6);
}

TEST(Plant, standsBelowTheDeadBandAndStopsWhenBraked) {
  Plant plant = perfectPlant();
  run(plant, 1000, {60, -60});
  EXPECT_EQ(plant.pose(), Pose{});
  run(plant, 1000, {500, 500});
  run(plant, 500, {0, 0});
  EXPECT_EQ(plant.speed().value(), 0.0);
}

TEST(Plant, isSlowerOnAnEmptyBattery) {
  Plant full = perfectPlant();
  Plant empty = perfectPlant();
  for (int i = 0; i < 2000; ++i) {
    full.step(kMillisecond, {500, 500}, 12.5);
    empty.step(kMillisecond, {500, 500}, 10.5);
  }
  EXPECT_LT(empty.speed().value(), full.speed().value() - 0.05);
}

TEST(Plant, drivesInACurveByTheMismatchOfItsMotorsAndTheSameOneForTheSameSeed) {
  const auto end = [](std::uint64_t seed) {
    Plant plant{PlantParameters{}, Pose{}, RandomStream{seed, "plant", 3}};
    run(plant, 3000, {500, 500});
    return plant.pose();
  };
  EXPECT_EQ(end(5), end(5));
  EXPECT_NE(end(5), end(6));
  double turns = 0.0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) turns += std::abs(end(seed).heading.value());
  EXPECT_GT(turns / 20, 0.02);
  EXPECT_LT(turns / 20, 1.0);
}

TEST(Plant, hasOdometryThatIsWrongByAboutAPercent) {
  double squares = 0.0;
  constexpr int kRuns = 200;
  for (std::uint64_t seed = 0; seed < kRuns; ++seed) {
    PlantParameters parameters;
    parameters.motorMismatch = 0.0;
    Plant plant{parameters, Pose{}, RandomStream{seed, "plant"}};
    Metres way;
    for (int i = 0; i < 4000; ++i) {
      const Point before = plant.pose().position;
      plant.step(kMillisecond, {500, 500}, kMotorVolts);
      way += distance(before, plant.pose().position);
    }
    const double measured = (plant.wheelAngle(0).value() + plant.wheelAngle(1).value()) / 2 * 0.05;
    squares += std::pow(measured / way.value() - 1.0, 2);
  }
  EXPECT_NEAR(std::sqrt(squares / kRuns), 0.012, 0.004);
}

TEST(Plant, isOffByLessWhereWhatTheWheelsHaveInCommonIsForgottenSooner) {
  // A share s that is remembered for m seconds makes the way of t seconds at v uncertain by v·s·sqrt(2·m·t).
  for (const double memory : {0.5, 0.05}) {
    double squares = 0.0;
    constexpr int kPlants = 200;
    for (int seed = 1; seed <= kPlants; ++seed) {
      PlantParameters p = perfect();
      p.speedNoise = 0.1;
      p.speedNoiseMemory = Seconds{memory};
      Plant plant{p, Pose{}, RandomStream{static_cast<std::uint64_t>(seed), "plant"}};
      run(plant, 10'000, {200, 200});
      const double rolled = plant.wheelAngle(0).value() * plant.trueDiameter(0).value() / 2.0;
      squares += std::pow(plant.pose().position.x.value() - rolled, 2.0) / kPlants;
    }
    const double expected = (0.2 * 0.8 - 0.03) * 0.1 * std::sqrt(2.0 * memory * 10.0);
    EXPECT_NEAR(std::sqrt(squares), expected, 0.15 * expected) << memory;
  }
}

TEST(Plant, turnsNoWheelWhenItIsLiftedAndNoJammedOne) {
  Plant plant = perfectPlant();
  plant.setPose({{Metres{3.0}, Metres{4.0}}, Radians{1.0}});
  EXPECT_EQ(plant.encoderCounts(), (std::array<std::int64_t, 2>{}));
  plant.setBlocked(0, true);
  run(plant, 500, {500, 500});
  EXPECT_EQ(plant.encoderCounts()[0], 0);
  EXPECT_GT(plant.encoderCounts()[1], 20);
}

}  // namespace
}  // namespace tessera::sim
