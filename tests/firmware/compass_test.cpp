#include "firmware/vehicle/compass.h"

#include <gtest/gtest.h>

#include "firmware/vehicle/angles.h"
#include "tests/firmware/fake_board.h"

namespace tessera::firmware::test {
namespace {

using wire::Parameter;

struct CompassBench {
  FakeBoard board;
  Compass compass{board};
  std::optional<Compass::Sample> last;
  int samples = 0;

  CompassBench() { setField(20.0, 0.0); }
  void setField(double x, double y) { board.compass.field = {x, y, 40.0}; }
  void run(std::uint64_t us) {
    for (const std::uint64_t end = board.time + us; board.time < end; board.time += 10'000)
      if (const auto s = compass.tick(Micros{static_cast<std::int64_t>(board.time)})) {
        last = s;
        ++samples;
      }
  }
};

TEST(Compass, readsFiftyTimesASecond) {
  CompassBench bench;
  bench.run(1'000'000);
  EXPECT_GE(bench.samples, 45);
  EXPECT_LE(bench.samples, 50);
  EXPECT_FALSE(bench.compass.absent());
}

TEST(Compass, pointsClockwiseFromNorth) {
  // With the nose to the east, north lies to the left: along +y.
  CompassBench bench;
  bench.setField(0.0, 20.0);
  bench.run(100'000);
  ASSERT_TRUE(bench.last);
  EXPECT_NEAR(bench.last->bearing, kPi / 2, 0.01);
  EXPECT_NEAR(bench.last->raw.y, 20.0, 0.1);
  EXPECT_TRUE(bench.last->usable);
}

TEST(Compass, addsDeclinationAndTakesTheMountingOff) {
  CompassBench bench;
  Settings s;
  s.set(Parameter::Declination, 65536 / 16);     // 22.5 degrees east
  s.set(Parameter::CompassMounting, 65536 / 4);  // x axis points to the right
  bench.compass.configure(s);
  bench.setField(0.0, 20.0);  // the x axis points east, so the nose points north
  bench.run(100'000);
  EXPECT_NEAR(bench.last->bearing, kPi / 8, 0.01);
}

TEST(Compass, removesHardAndSoftIron) {
  CompassBench bench;
  Settings s;
  s.set(Parameter::CompassOffsetX, 60'000);
  s.set(Parameter::CompassOffsetY, -30'000);
  s.set(Parameter::CompassMatrixXX, 20'000);
  bench.compass.configure(s);
  bench.setField(60.0 + 10.0 * std::cos(0.5), -30.0 + 20.0 * std::sin(0.5));
  bench.run(100'000);
  EXPECT_NEAR(bench.last->bearing, 0.5, 0.01);
}

TEST(Compass, saysThatAFieldCannotBeTheEarths) {
  CompassBench bench;
  bench.setField(85.0, 0.0);
  bench.run(300'000);
  EXPECT_TRUE(bench.compass.outOfRange());
  EXPECT_FALSE(bench.last->usable);
  bench.setField(2.0, 0.0);
  bench.run(300'000);
  EXPECT_TRUE(bench.compass.outOfRange());
  bench.setField(20.0, 0.0);
  bench.run(100'000);
  EXPECT_FALSE(bench.compass.outOfRange());
}

TEST(Compass, widensItsRangeWhenItOverflowsAndDropsTheOldSample) {
  CompassBench bench;
  bench.run(100'000);
  bench.setField(300.0, 0.0);
  bench.samples = 0;
  bench.run(40'000);
  EXPECT_TRUE(bench.compass.outOfRange());
  EXPECT_EQ(bench.samples, 0);
  bench.run(1'000'000);
  EXPECT_GT(bench.board.compass.gain(), 1U);
  EXPECT_NEAR(bench.last->raw.x, 300.0, 1.0);
}

TEST(Compass, comesBackAfterTheChipWasAway) {
  CompassBench bench;
  bench.run(200'000);
  bench.board.compass.present = false;
  bench.run(200'000);
  EXPECT_TRUE(bench.compass.absent());
  bench.board.compass.present = true;
  const int before = bench.board.compass.configurations;
  bench.run(1'000'000);
  EXPECT_FALSE(bench.compass.absent());
  EXPECT_EQ(bench.board.compass.configurations, before + 1);
}

TEST(Compass, doesNotTakeAnotherChipForItsOwn) {
  CompassBench bench;
  bench.board.compass.id = {'H', '4', '4'};
  bench.run(2'000'000);
  EXPECT_TRUE(bench.compass.absent());
  EXPECT_EQ(bench.samples, 0);
}

}  // namespace
}  // namespace tessera::firmware::test
