#include "sim/commission.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firmware/vehicle/compass.h"
#include "floor/bearing.h"
#include "sim/test_floor.h"

namespace tessera::sim {
namespace {

using wire::Parameter;

floor::Site siteToNorth(double northToY) {
  floor::Site site;
  site.northToY = Radians{northToY};
  return site;
}

/// Largest error over all headings of the bearing that the firmware computes from the noiseless field.
double worstError(const EepromImage& image, CompassParameters compass, Radians northToY, std::uint64_t seed) {
  const auto settings = firmware::settingsFromImage(image);
  if (!settings) return 360.0;
  const firmware::CompassCorrection correction = firmware::correctionFrom(*settings);
  compass.noise = 0.0;
  CompassField field{compass, northToY, {}, RandomStream{seed, "compass", testVehicle().id.value}};
  double worst = 0.0;
  for (double heading = -3.1; heading < 3.1; heading += 0.05) {
    const auto raw = field.measure({{}, Radians{heading}});
    const auto corrected = correction.apply({static_cast<float>(raw[0]), static_cast<float>(raw[1])});
    const Radians bearing{std::atan2(double{corrected.y}, double{corrected.x})};
    const Radians truth = floor::bearingOfHeading(Radians{heading}, northToY);
    worst = std::max(worst, std::abs(degrees(turnBetween(truth, bearing))));
  }
  return worst;
}

TEST(Commissioning, leavesLessThanTwoDegreesOfErrorInAnyDirection) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    BodyParameters body = bodyParametersFor(testVehicle());
    body.compass.bias = Radians{};  // a chip mounted askew cannot be told from the field alone
    const auto image = commissionEeprom(testVehicle(), siteToNorth(0.7), body, seed);
    ASSERT_TRUE(image) << image.error().sentence;
    const double worst = worstError(*image, body.compass, Radians{0.7}, seed);
    EXPECT_LT(worst, 2.0) << seed;
    EXPECT_GT(worst, 0.0) << "measured by the vehicle, not copied from the truth";
  }
}

TEST(Commissioning, leavesTheErrorOfTheChipsMounting) {
  const BodyParameters body = bodyParametersFor(testVehicle());
  const auto image = commissionEeprom(testVehicle(), siteToNorth(0.0), body, 8);
  ASSERT_TRUE(image) << image.error().sentence;
  const double worst = worstError(*image, body.compass, Radians{}, 8);
  EXPECT_GT(worst, 1.5);
  EXPECT_LT(worst, 4.0);
}

TEST(Commissioning, isDoneOnADryFloorAndAgainWhereTheCompassIsNoisy) {
  BodyParameters body = bodyParametersFor(testVehicle());
  body.plant.slip = 0.2;
  body.plant.speedNoise = 0.2;
  body.compass.noise = kEarthHorizontal * fromDegrees(2.0).value();
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto image = commissionEeprom(testVehicle(), siteToNorth(0.0), body, seed);
    EXPECT_TRUE(image) << seed << ": " << image.error().sentence;
  }
}

TEST(Commissioning, makesTheSameImageForTheSameSeed) {
  const BodyParameters body = bodyParametersFor(testVehicle());
  const auto once = commissionEeprom(testVehicle(), siteToNorth(0.0), body, 5);
  ASSERT_TRUE(once);
  EXPECT_EQ(*once, *commissionEeprom(testVehicle(), siteToNorth(0.0), body, 5));
  EXPECT_NE(*once, *commissionEeprom(testVehicle(), siteToNorth(0.0), body, 6));
}

TEST(Commissioning, writesWhatTheSetupSays) {
  floor::VehicleSetup setup = testVehicle();
  setup.wheelDiameter = Metres{0.12};
  setup.track = Metres{0.34};
  setup.maxSpeed = MetresPerSecond{0.4};
  floor::Site site;
  site.radio = {17, 9600, 57600};
  const auto image = commissionEeprom(setup, site, bodyParametersFor(setup), 1);
  ASSERT_TRUE(image) << image.error().sentence;
  const auto settings = firmware::settingsFromImage(*image);
  ASSERT_TRUE(settings);
  EXPECT_EQ(settings->key, setup.key);
  EXPECT_EQ(settings->get(Parameter::Address), 7);
  EXPECT_EQ(settings->get(Parameter::WheelDiameter), 120'000);
  EXPECT_EQ(settings->get(Parameter::TrackWidth), 340'000);
  EXPECT_EQ(settings->get(Parameter::MaxSpeed), 400);
  EXPECT_EQ(settings->get(Parameter::ReaderCount), 3);
  EXPECT_EQ(settings->get(Parameter::RadioChannel), 17);
  EXPECT_EQ(settings->get(Parameter::RadioAirRate), 4);
  EXPECT_EQ(settings->get(Parameter::RadioBaud), 6);
  EXPECT_EQ(settings->get(Parameter::Declination), 0);
}

TEST(Commissioning, refusesWhatTheFirmwareDoesNotTake) {
  floor::VehicleSetup setup = testVehicle();
  setup.track = Metres{0.0};
  const auto image = commissionEeprom(setup, floor::Site{}, bodyParametersFor(setup), 1);
  ASSERT_FALSE(image);
  EXPECT_NE(image.error().sentence.english().find("test vehicle"), std::string::npos);
  floor::Site site;
  site.radio.airRate = 1234;
  EXPECT_FALSE(commissionEeprom(testVehicle(), site, bodyParametersFor(testVehicle()), 1));
}

}  // namespace
}  // namespace tessera::sim
