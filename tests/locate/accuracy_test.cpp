// How well the locators find the vehicle on the publication's floor. Each test prints what it measured; the numbers in
// docs/decisions/0004-locator-and-controller.md are these.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "locate/kalman_locator.h"
#include "locate/paper_floor.h"
#include "locate/synthetic_drive.h"

namespace tessera::test {
namespace {

constexpr std::uint32_t kSeeds = 10;

/// Mean over the seeds, without the first 5 s of each drive, on the publication's route unless another is given.
ErrorSummary measure(std::string_view locator, int readers, DriveOptions options, const char* what,
                     std::vector<Point> route = {}) {
  const auto map = paperMap();
  if (route.empty()) route = map->route("paper")->vertices;
  const floor::VehicleSetup vehicle = paperVehicle(readers);
  ErrorSummary mean;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    options.seed = seed;
    const auto made = locate::makeLocator(locator, map, vehicle);
    const ErrorSummary one = summarise(drive(*map, vehicle, route, options, **made), 5.0);
    mean.mean += one.mean / kSeeds;
    mean.p95 += one.p95 / kSeeds;
    mean.headingRms += one.headingRms / kSeeds;
    mean.locatedShare += one.locatedShare / kSeeds;
  }
  std::printf("%-10s %-34s mean %.2f cm, p95 %.2f cm, heading rms %.2f deg, located %.3f\n",
              std::string{locator}.c_str(), what, 100 * mean.mean, 100 * mean.p95, mean.headingRms * 180 / kPi,
              mean.locatedShare);
  return mean;
}

TEST(Accuracy, kalmanWithThreeReadersStaysUnderTwoCentimetres) {
  const ErrorSummary e = measure("kalman", 3, {}, "3 readers, 12 cm/s");
  EXPECT_LT(e.mean, 0.020);
  EXPECT_LT(e.p95, 0.045);
  EXPECT_GT(e.locatedShare, 0.999);
}

TEST(Accuracy, theTagsCentreAloneIsTwiceAsFarOff) {
  const ErrorSummary e = measure("tag-centre", 3, {}, "3 readers, 12 cm/s");
  EXPECT_GT(e.mean, 0.03);
  EXPECT_LT(e.mean, 0.06);
}

TEST(Accuracy, theRimsTellALittleMoreThanTheDiscsAlone) {
  const auto map = paperMap();
  const floor::VehicleSetup vehicle = paperVehicle();
  double withRims = 0.0;
  double discsOnly = 0.0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    DriveOptions options;
    options.seed = seed;
    locate::DiscModel blind;
    blind.detection = 0.0;  // silence before and after a visit then says nothing
    locate::KalmanLocator rims{map, vehicle};
    locate::KalmanLocator discs{map, vehicle, {}, blind};
    const std::vector<Point>& route = map->route("paper")->vertices;
    withRims += summarise(drive(*map, vehicle, route, options, rims), 5.0).mean / kSeeds;
    discsOnly += summarise(drive(*map, vehicle, route, options, discs), 5.0).mean / kSeeds;
  }
  std::printf("kalman     with rims mean %.2f cm, discs only mean %.2f cm\n", 100 * withRims, 100 * discsOnly);
  EXPECT_LT(withRims, discsOnly);
}

TEST(Accuracy, kalmanBearsOneReaderOnly) {
  // The publication's route runs midway between the tags' rows: one reader in the middle would see next to nothing.
  const std::vector<Point> aslant{{Metres{0.30}, Metres{0.25}}, {Metres{0.55}, Metres{1.50}},
                                  {Metres{1.00}, Metres{1.45}}, {Metres{0.80}, Metres{0.30}},
                                  {Metres{1.45}, Metres{0.40}}, {Metres{1.30}, Metres{1.50}}};
  EXPECT_LT(measure("kalman", 1, {}, "1 reader, 12 cm/s, aslant", aslant).mean, 0.035);
  EXPECT_LT(measure("kalman", 3, {}, "3 readers, 12 cm/s, aslant", aslant).mean, 0.020);
  EXPECT_LT(measure("kalman", 5, {}, "5 readers, 12 cm/s").mean, 0.018);
}

TEST(Accuracy, kalmanBearsOtherSpeeds) {
  for (const double speed : {0.05, 0.08, 0.20, 0.40}) {
    DriveOptions options;
    options.speed = speed;
    const std::string what = "3 readers, " + std::to_string(static_cast<int>(100 * speed + 0.5)) + " cm/s";
    EXPECT_LT(measure("kalman", 3, options, what.c_str()).mean, 0.03) << speed;
  }
}

TEST(Accuracy, kalmanBearsAFifthOfTheEventsLost) {
  DriveOptions options;
  options.lostEvents = 0.2;
  EXPECT_LT(measure("kalman", 3, options, "20 % of events lost").mean, 0.025);
}

TEST(Accuracy, kalmanBearsFiveDegreesOfCompassBias) {
  DriveOptions options;
  options.compassBias = 5.0;
  const ErrorSummary e = measure("kalman", 3, options, "5 deg compass bias");
  EXPECT_LT(e.mean, 0.025);
  EXPECT_LT(e.headingRms, 4.0 * kPi / 180) << "the bias should be learned in part";
}

TEST(Accuracy, kalmanBearsUnknownTags) {
  DriveOptions options;
  options.unknownTags = 0.2;
  EXPECT_LT(measure("kalman", 3, options, "20 % of UIDs unknown").mean, 0.025);
}

TEST(Accuracy, kalmanBearsLateAndShuffledReports) {
  DriveOptions options;
  options.shuffled = true;
  EXPECT_LT(measure("kalman", 3, options, "shuffled, every third 1 s late").mean, 0.025);
}

TEST(Accuracy, kalmanTakesEveryReadAsWellAsOnlyTheFirst) {
  DriveOptions options;
  options.everyRead = true;
  EXPECT_LT(measure("kalman", 3, options, "every read told").mean, 0.020);
  EXPECT_LT(measure("tag-centre", 3, options, "every read told").mean, 0.06);
}

TEST(Accuracy, kalmanGainsFromGoodEncoders) {
  DriveOptions options;
  options.speedNoise = 0.02;
  EXPECT_LT(measure("kalman", 3, options, "odometer noise 2 %").mean, 0.018);
  options.pollPeriod = 0.2;
  EXPECT_LT(measure("kalman", 3, options, "odometer noise 2 %, polls of 0.2 s").mean, 0.025);
}

}  // namespace
}  // namespace tessera::test
