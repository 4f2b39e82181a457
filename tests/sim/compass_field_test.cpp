#include "sim/compass_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "floor/bearing.h"
#include "sim/test_floor.h"

namespace tessera::sim {
namespace {

constexpr Radians kNorthToY{0.4};

CompassParameters plain() {
  CompassParameters p;
  p.noise = p.hardIron = p.hardIronSpread = p.softIron = 0.0;
  p.bias = Radians{};
  return p;
}

Pose facing(double heading) { return {{}, Radians{heading}}; }

Radians bearingOf(const std::array<double, 3>& field) { return Radians{std::atan2(field[1], field[0])}; }

TEST(CompassField, showsTheBearingOfTheNoseClockwiseFromNorth) {
  CompassField field{plain(), kNorthToY, {}, RandomStream{1, "compass"}};
  for (double heading = -3.0; heading < 3.1; heading += 0.25) {
    const Radians expected = floor::bearingOfHeading(Radians{heading}, kNorthToY);
    EXPECT_NEAR(turnBetween(expected, bearingOf(field.measure(facing(heading)))).value(), 0.0, 1e-9) << heading;
  }
  // A vehicle that faces along +y has the site's northToY as its bearing.
  EXPECT_NEAR(bearingOf(field.measure(facing(kPi / 2))).value(), kNorthToY.value(), 1e-9);
}

TEST(CompassField, isPositiveAndWithinTheChipsRangeInEveryDirection) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    CompassField field{CompassParameters{}, kNorthToY, {}, RandomStream{seed, "compass"}};
    for (double heading = 0.0; heading < 6.3; heading += 0.1)
      for (const double axis : field.measure(facing(heading))) {
        EXPECT_GT(axis, 1.0);
        EXPECT_LT(axis, 180.0);
      }
  }
}

TEST(CompassField, isNoisyAsTheChip) {
  CompassField field{CompassParameters{}, kNorthToY, {}, RandomStream{2, "compass"}};
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kSamples = 5000;
  for (int i = 0; i < kSamples; ++i) {
    const double x = field.measure(Pose{})[0];
    sum += x;
    squares += x * x;
  }
  const double mean = sum / kSamples;
  EXPECT_NEAR(std::sqrt(squares / kSamples - mean * mean), 0.2, 0.02);
}

TEST(CompassField, isTurnedByTheBiasOneWayOrTheOther) {
  CompassParameters parameters = plain();
  parameters.bias = fromDegrees(2.0);
  int positive = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CompassField field{parameters, Radians{}, {}, RandomStream{seed, "compass"}};
    const double error = degrees(bearingOf(field.measure(facing(kPi / 2))));
    EXPECT_NEAR(std::abs(error), 2.0, 1e-9);
    if (error > 0) ++positive;
  }
  EXPECT_GT(positive, 10);
  EXPECT_LT(positive, 30);
}

TEST(CompassField, deviatesAtASpotAndNotFarFromIt) {
  // The earth's field runs along +y here; a spot across it.
  const double peak = kEarthHorizontal * std::tan(fromDegrees(5.0).value());
  const std::vector<MagneticSpot> spots{{{Metres{1.0}, Metres{1.0}}, Metres{0.3}, {peak, 0.0}}};
  CompassField field{plain(), Radians{}, spots, RandomStream{1, "compass"}};
  const Pose over{{Metres{1.0}, Metres{1.0}}, Radians{kPi / 2}};
  const Pose away{{Metres{3.0}, Metres{1.0}}, Radians{kPi / 2}};
  EXPECT_NEAR(std::abs(degrees(bearingOf(field.measure(over)))), 5.0, 1e-6);
  EXPECT_NEAR(degrees(bearingOf(field.measure(away))), 0.0, 1e-6);
}

TEST(CompassField, spreadsTheSameSpotsOverTheFloorForTheSameSeed) {
  const floor::Site site = testSite(20);  // 3 m square: six spots
  const auto spots = seededSpots(site, kSpotDeviation, 4);
  ASSERT_EQ(spots.size(), 6U);
  EXPECT_EQ(spots[3].centre, seededSpots(site, kSpotDeviation, 4)[3].centre);
  EXPECT_NE(spots[3].centre, seededSpots(site, kSpotDeviation, 5)[3].centre);
  for (const MagneticSpot& spot : spots) {
    EXPECT_TRUE(spot.centre.x >= Metres{} && spot.centre.x <= Metres{3.0});
    EXPECT_NEAR(std::hypot(spot.peak[0], spot.peak[1]), kEarthHorizontal * std::tan(kSpotDeviation.value()), 0.01);
  }
  EXPECT_TRUE(seededSpots(site, Radians{}, 4).empty());
  EXPECT_TRUE(seededSpots(floor::Site{}, kSpotDeviation, 4).empty());
}

}  // namespace
}  // namespace tessera::sim
