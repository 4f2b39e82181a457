// Readers and wheels calibrated with the firmware's own vehicle: it drives the figure, and what it told gives its
// readers' true places back, whatever was entered.
#include "calibrate/figure.h"
#include "calibrate/reader_calibration.h"
#include "scenario/scenario.h"
#include "supervisor/locating_view.h"

namespace tessera::scenario {
namespace {

calibrate::DriveRecord driveFigure(std::uint64_t seed, floor::VehicleSetup& truth) {
  ScenarioSetup setup;
  setup.seed = seed;
  setup.assignments = {{VehicleId{1}, "Calibration"}};
  setup.change = [&](floor::Site& site) {
    site.routes = {{"Calibration",
                    calibrate::figure({Metres{0.9}, Metres{0.9}}, Metres{0.6}, Radians{0.35 + 0.2 * double(seed)})}};
    truth = site.vehicles.front();
  };
  Scenario scenario{setup};
  scenario.supervisor().post(supervisor::Watch{VehicleId{1}});
  scenario.orderRoutes();
  calibrate::DriveRecord drive;
  std::optional<Seconds> last;
  const auto record = [&] {
    const auto& snapshot = scenario.lockstep().snapshot();
    if (!snapshot || !snapshot->watched) return false;
    drive.add(snapshot->watched->motion);
    for (const supervisor::ReadView& read : snapshot->find(VehicleId{1})->recentReads) {
      if (last && read.at <= *last) continue;
      last = read.at;
      if (read.place) drive.add(calibrate::PlacedRead{read.reader, *read.place, read.at});
    }
    return scenario.finished();
  };
  EXPECT_TRUE(scenario.until(Seconds{900}, record)) << scenario.sentences();
  return drive;
}

TEST(Calibration, findsTheReadersOfTheFirmwaresVehicleWithinTheStatedDeviations) {
  floor::VehicleSetup truth;
  const calibrate::DriveRecord drive = driveFigure(1, truth);
  floor::VehicleSetup entered = truth;
  for (std::size_t r = 0; r < entered.readers.size(); ++r)
    entered.readers[r] = entered.readers[r] + Offset{Metres{r % 2 == 0 ? 0.02 : -0.015}, Metres{0.015}};
  const auto result = calibrate::calibrateReaders(drive, entered);
  ASSERT_TRUE(result) << result.error().sentence.english();
  std::printf("%d reads, %d outliers, unrest %.3f, wheels %+.4f ± %.4f\n", result->reads, result->outliers,
              result->unrest, result->wheelScale - 1.0, result->wheelSigma);
  EXPECT_NEAR(result->wheelScale, 1.0, 4.0 * result->wheelSigma);
  EXPECT_LT(result->wheelSigma, 0.01);
  for (std::size_t r = 0; r < truth.readers.size(); ++r) {
    const auto& found = result->readers[r];
    const Offset off = found.mount + -1.0 * truth.readers[r];
    std::printf("reader %zu: ahead %+.1f ± %.1f mm, aside %+.1f ± %.1f mm\n", r + 1, 1000 * off.x.value(),
                1000 * found.sigmaAhead.value(), 1000 * off.y.value(), 1000 * found.sigmaAside.value());
    EXPECT_LT(length(off), Metres{0.015});
    EXPECT_LT(abs(off.x) / found.sigmaAhead, 3.5);
    EXPECT_LT(abs(off.y) / found.sigmaAside, 3.5);
  }
}

}  // namespace
}  // namespace tessera::scenario
