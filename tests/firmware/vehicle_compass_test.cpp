// The whole vehicle and its compass: calibrated, surveyed, failing, and the heading held by it.
#include <gtest/gtest.h>

#include "tests/firmware/vehicle_bench.h"

namespace tessera::firmware::test {
namespace {

using wire::MessageType;
using wire::Outcome;
using wire::Parameter;
using wire::VehicleState;

double radiansOf(double degrees) { return degrees * M_PI / 180.0; }

TEST(VehicleCompass, keepsItsHeadingFromTheWheelsWhenTheCompassFails) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  bench.drive(200, 0.0, 2000);
  bench.board.compass.present = false;
  bench.drive(200, radiansOf(60), 4000);
  EXPECT_NEAR(bench.plant.bearing, radiansOf(60), radiansOf(3));
  EXPECT_EQ(bench.host.report->faults, wire::kFaultCompass);
}

TEST(VehicleCompass, calibratesItsCompassWhenAsked) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  // The plant's field, bent as by an iron chassis.
  bench.everyMs = [&] {
    const auto f = bench.board.compass.field;
    bench.board.compass.field = {1.3 * f[0] + 0.2 * f[1] + 60.0, 0.2 * f[0] + 0.8 * f[1] + 45.0, 40.0};
  };
  bench.run(500);
  EXPECT_EQ(bench.state(), VehicleState::Standing);
  EXPECT_EQ(bench.host.report->faults, wire::kFaultCompassRange);
  EXPECT_EQ(bench.ask(MessageType::Do, static_cast<std::uint8_t>(wire::Action::CalibrateCompass)).outcome,
            Outcome::Started);
  bench.run(500);
  EXPECT_EQ(bench.state(), VehicleState::Calibrating);
  EXPECT_EQ(bench.ask(MessageType::Do, static_cast<std::uint8_t>(wire::Action::CalibrateCompass)).outcome,
            Outcome::Busy);
  for (int i = 0; i < 60 && bench.state() == VehicleState::Calibrating; ++i) bench.run(500);
  EXPECT_EQ(bench.ask(MessageType::Get, static_cast<std::uint8_t>(Parameter::CalibrationOutcome)).value,
            static_cast<int>(Outcome::Done));
  bench.run(1500);
  for (const double bearing : {0.0, 100.0, -130.0}) {
    bench.drive(0, radiansOf(bearing), 4000);
    EXPECT_NEAR(std::remainder(bench.plant.bearing - radiansOf(bearing), 2 * M_PI), 0.0, radiansOf(2.0)) << bearing;
  }
  EXPECT_EQ(bench.host.report->faults, 0);
  const auto kept = settingsFromImage(bench.board.memory.cells);
  ASSERT_TRUE(kept);
  EXPECT_NEAR(kept->get(Parameter::CompassOffsetX), 60'000, 500);
}

TEST(VehicleCompass, tellsWhatItsCompassMeasuredAllAroundAndChangesNothing) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  bench.everyMs = [&] {
    const auto f = bench.board.compass.field;
    bench.board.compass.field = {f[0] + 60.0, f[1] - 45.0, 40.0};
  };
  const auto sample = [&](int direction) {
    const auto first = static_cast<int>(Parameter::CompassSample);
    const wire::Value v = bench.ask(MessageType::Get, static_cast<std::uint8_t>(first + direction));
    EXPECT_EQ(v.outcome, Outcome::Done);
    return v.value;
  };
  const auto survey = static_cast<std::uint8_t>(wire::Action::SurveyCompass);
  const auto before = bench.board.memory.cells;
  EXPECT_EQ(sample(32), wire::kNoCompassSample) << "it has not turned yet";
  EXPECT_EQ(bench.ask(MessageType::Do, survey).outcome, Outcome::Started);
  bench.run(500);
  EXPECT_EQ(bench.ask(MessageType::Do, survey).outcome, Outcome::Busy);
  EXPECT_NE(sample(32), wire::kNoCompassSample) << "the turn begins with it";
  EXPECT_EQ(sample(31), wire::kNoCompassSample) << "and ends with this one";
  for (int i = 0; i < 60 && bench.state() == VehicleState::Calibrating; ++i) bench.run(500);
  for (int direction = 0; direction < wire::kCompassSamples; ++direction) {
    const wire::CompassCounts c = wire::unpackCompass(sample(direction));
    EXPECT_NEAR(std::hypot(c.x * 0.025 - 60.0, c.y * 0.025 + 45.0), 20.0, 1.0) << direction;
  }
  EXPECT_EQ(bench.ask(MessageType::Get, static_cast<std::uint8_t>(Parameter::CompassSample) + 64).outcome,
            Outcome::Unknown);
  EXPECT_EQ(bench.ask(MessageType::Get, static_cast<std::uint8_t>(Parameter::CompassOffsetX)).value, 0);
  EXPECT_EQ(bench.board.memory.cells, before);
}

TEST(VehicleCompass, endsACalibrationWhenTheHostFallsSilentOrSaysStop) {
  for (const bool stop : {true, false}) {
    VehicleBench bench;
    ASSERT_TRUE(bench.open());
    bench.ask(MessageType::Do, static_cast<std::uint8_t>(wire::Action::CalibrateCompass));
    bench.run(1000);
    EXPECT_FALSE(bench.plant.standing());
    if (stop) bench.say(bench.host.stop());
    bench.run(stop ? 1000 : 2500);
    EXPECT_TRUE(bench.plant.standing());
    EXPECT_EQ(bench.state(), VehicleState::Standing);
    EXPECT_EQ(bench.ask(MessageType::Get, static_cast<std::uint8_t>(Parameter::CalibrationOutcome)).value,
              static_cast<int>(Outcome::Failed));
  }
}

}  // namespace
}  // namespace tessera::firmware::test
