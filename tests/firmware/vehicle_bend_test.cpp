// The whole vehicle on unequal tyres: it holds a bearing straight once it has learned how they bend its way.
#include <gtest/gtest.h>

#include "tests/firmware/vehicle_bench.h"

namespace tessera::firmware::test {
namespace {

using wire::MessageType;
using wire::Outcome;
using wire::Parameter;

constexpr auto kLearning = static_cast<std::uint8_t>(Parameter::HeadingLearning);

std::unique_ptr<VehicleBench> onUnequalTyres(double difference) {
  auto bench = std::make_unique<VehicleBench>();
  bench->plant.wheels[0].tyre = 1.0 - difference;
  return bench;
}

// Millimetres aside for each metre while it goes northwards, without a host that would look where it goes.
double asideOver(VehicleBench& bench, std::int16_t mmPerSecond, double metres) {
  const double x = bench.plant.x;
  const double y = bench.plant.y;
  bench.drive(mmPerSecond, 0.0, static_cast<int>(1e6 * metres / mmPerSecond));
  return 1000.0 * std::fabs(bench.plant.x - x) / std::fabs(bench.plant.y - y);
}

TEST(VehicleOnUnequalTyres, goesAsideUntilItHasLearned) {
  for (const std::int16_t speed : std::initializer_list<std::int16_t>{120, 500}) {
    const auto bench = onUnequalTyres(0.10);
    ASSERT_TRUE(bench->open());
    ASSERT_EQ(bench->ask(MessageType::Set, kLearning, 0).outcome, Outcome::Done);
    const double before = asideOver(*bench, speed, 5.0);
    ASSERT_EQ(bench->ask(MessageType::Set, kLearning, 10'000).outcome, Outcome::Done);
    asideOver(*bench, speed, 40.0);
    const double after = asideOver(*bench, speed, 5.0);
    EXPECT_GT(before, speed == 500 ? 120.0 : 30.0) << speed;
    EXPECT_LT(after, 0.06 * before) << speed;
    RecordProperty("mm_a_metre_before_at_" + std::to_string(speed), std::to_string(before));
    RecordProperty("mm_a_metre_after_at_" + std::to_string(speed), std::to_string(after));
  }
}

TEST(VehicleOnUnequalTyres, keepsWhatItLearnedOverAStopAndATurnButNotWithoutPower) {
  const auto bench = onUnequalTyres(0.10);
  ASSERT_TRUE(bench->open());
  asideOver(*bench, 500, 40.0);
  bench->say(bench->host.stop());
  bench->run(20'000);
  bench->drive(0, M_PI / 2, 4000);
  bench->drive(0, 0.0, 4000);
  EXPECT_LT(asideOver(*bench, 500, 3.0), 20.0);
  bench->say(bench->host.stop());
  bench->run(2000);
  bench->switchOn();
  bench->host = TestHost{VehicleBench::kAddress, VehicleBench::kKey};
  ASSERT_TRUE(bench->open(2));
  EXPECT_GT(asideOver(*bench, 500, 3.0), 60.0) << "the tyres may have been changed meanwhile";
}

TEST(VehicleOnUnequalTyres, learnsNothingOnEqualOnes) {
  const auto drive = [](std::int32_t learning) {
    VehicleBench bench{[&](Settings& s) { s.set(Parameter::HeadingLearning, learning); }};
    EXPECT_TRUE(bench.open());
    bench.drive(300, 0.5, 30'000);
    return std::pair{bench.plant.x, bench.plant.y};
  };
  EXPECT_EQ(drive(10'000), drive(0));
}

TEST(VehicleOnUnequalTyres, keepsTheLengthOfItsLearningInTheEeprom) {
  VehicleBench bench;
  ASSERT_TRUE(bench.open());
  EXPECT_EQ(bench.ask(MessageType::Set, kLearning, 100'001).outcome, Outcome::OutOfRange);
  EXPECT_EQ(bench.ask(MessageType::Set, kLearning, -1).outcome, Outcome::OutOfRange);
  ASSERT_EQ(bench.ask(MessageType::Set, kLearning, 15'000).outcome, Outcome::Done);
  bench.run(1500);
  bench.switchOn();
  bench.host = TestHost{VehicleBench::kAddress, VehicleBench::kKey};
  ASSERT_TRUE(bench.open(2));
  EXPECT_EQ(bench.ask(MessageType::Get, kLearning).value, 15'000);
}

}  // namespace
}  // namespace tessera::firmware::test
