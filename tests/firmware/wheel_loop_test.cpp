#include "firmware/vehicle/wheel_loop.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/firmware/fake_plant.h"

namespace tessera::firmware::test {
namespace {

struct WheelBench {
  FakeWheel wheel;
  WheelLoop loop;
  double wanted = 0.0;
  double fastest = 0.0;
  int duty = 0;

  // Towards `target` at 0.5 m/s².
  void run(double target, double seconds) {
    for (int tick = 0; tick < seconds * 100; ++tick) {
      loop.measure(wheel.counts());
      const double before = wanted;
      wanted += std::clamp(target - wanted, -0.005, 0.005);
      duty = loop.drive(static_cast<float>(wanted), static_cast<float>((wanted - before) * 100));
      for (int i = 0; i < 10; ++i) wheel.step(0.001, duty);
      fastest = std::max(fastest, wheel.speed);
    }
  }
  void release(double seconds, double pushedAt = 0.0) {
    for (int tick = 0; tick < seconds * 100; ++tick) {
      loop.measure(wheel.counts());
      duty = loop.release();
      wheel.way += pushedAt * 0.01;
    }
  }
};

TEST(WheelLoop, reachesItsSpeedWithoutOvershoot) {
  for (const double fullSpeed : {0.6, 0.8, 1.1})
    for (const double lag : {0.05, 0.10, 0.25}) {
      WheelBench bench;
      bench.wheel.fullSpeed = fullSpeed;
      bench.wheel.lag = lag;
      bench.run(0.3, 3.0);
      EXPECT_NEAR(bench.wheel.speed, 0.3, 0.015) << fullSpeed << ' ' << lag;
      EXPECT_LT(bench.fastest, 0.36) << fullSpeed << ' ' << lag;
    }
}

TEST(WheelLoop, keepsAWalkingPaceThatIsSlowerThanOneCountATick) {
  WheelBench bench;
  bench.run(0.05, 2.0);
  const double start = bench.wheel.way;
  bench.run(0.05, 4.0);
  EXPECT_NEAR((bench.wheel.way - start) / 4.0, 0.05, 0.002);
  EXPECT_NEAR(bench.loop.speed(), 0.05, 0.01);
}

TEST(WheelLoop, drivesBackwardsAsWell) {
  WheelBench bench;
  bench.run(-0.2, 3.0);
  EXPECT_NEAR(bench.wheel.speed, -0.2, 0.01);
  EXPECT_NEAR(bench.loop.speed(), -0.2, 0.015);
}

TEST(WheelLoop, doesNotWindUpWhenAskedForMoreThanThereIs) {
  WheelBench bench;
  bench.wheel.fullSpeed = 0.4;
  bench.run(0.6, 10.0);
  bench.run(0.2, 1.5);
  bench.fastest = 0.0;
  bench.run(0.2, 2.0);
  EXPECT_LT(bench.fastest, 0.24);
  EXPECT_NEAR(bench.wheel.speed, 0.2, 0.02);
}

TEST(WheelLoop, noticesAWheelThatIsStuck) {
  WheelBench bench;
  bench.wheel.blocked = true;
  bench.run(0.2, 0.4);
  EXPECT_FALSE(bench.loop.stalled());
  bench.run(0.2, 2.0);
  EXPECT_TRUE(bench.loop.stalled());
  bench.loop.forgive();
  EXPECT_FALSE(bench.loop.stalled());
}

TEST(WheelLoop, noticesAStuckWheelAtTheSlowestPaceWithinThreeSeconds) {
  WheelBench bench;
  bench.wheel.blocked = true;
  bench.run(0.05, 3.0);
  EXPECT_TRUE(bench.loop.stalled());
}

TEST(WheelLoop, noticesAnEncoderThatCountsTheWrongWay) {
  WheelBench bench;
  bench.wheel.direction = -1.0;
  bench.run(0.2, 2.0);
  EXPECT_TRUE(bench.loop.implausible());
}

TEST(WheelLoop, noticesAWheelThatTurnsByItselfButNotOneThatRollsOut) {
  WheelBench bench;
  bench.run(0.4, 2.0);
  bench.release(0.3, 0.3);
  bench.release(2.0);
  EXPECT_FALSE(bench.loop.implausible());
  bench.release(2.0, 0.1);
  EXPECT_TRUE(bench.loop.implausible());
}

TEST(WheelLoop, findsNothingWrongWithOrdinaryDriving) {
  WheelBench bench;
  for (const double speed : {0.5, -0.5, 0.05, 0.0, -0.05, 0.3}) {
    bench.run(speed, 3.0);
    EXPECT_FALSE(bench.loop.stalled() || bench.loop.implausible()) << speed;
  }
}

TEST(WheelLoop, bearsCountsThatWrap) {
  WheelLoop loop;
  loop.configure(0.001F);
  loop.measure(0x7FFFFFFF);
  loop.measure(static_cast<std::int32_t>(0x80000001));
  EXPECT_NEAR(loop.step(), 0.002F, 1e-6F);
}

}  // namespace
}  // namespace tessera::firmware::test
