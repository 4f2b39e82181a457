// Noise on every line that comes from outside: the vehicle neither crashes nor moves, and hears its host afterwards.
#include <gtest/gtest.h>

#include <random>

#include "tests/firmware/vehicle_bench.h"

namespace tessera::firmware::test {
namespace {

struct Noise {
  std::mt19937 random;
  explicit Noise(unsigned seed) : random{seed} {}
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); }
  std::uint8_t byte() { return static_cast<std::uint8_t>(random()); }
};

TEST(VehicleUnderNoise, standsThroughRandomBytesOnBothLines) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    VehicleBench bench;
    ASSERT_TRUE(bench.open());
    Noise noise{seed};
    bench.everyMs = [&] {
      for (auto& line : bench.board.incoming)
        for (std::uint32_t n = noise.below(12); n > 0; --n)
          line.push_back(noise.below(8) == 0 ? std::uint8_t{0xA5} : noise.byte());
      bench.board.aux = noise.below(4) != 0;
      bench.board.echoes = {noise.below(60'000), noise.below(60'000)};
    };
    bench.run(10'000);
    EXPECT_TRUE(bench.plant.standing());
    bench.everyMs = [] {};
    bench.board.aux = true;
    bench.run(200);
    bench.host.report.reset();
    bench.say(bench.host.poll());
    EXPECT_TRUE(bench.host.report) << seed;
  }
}

TEST(VehicleUnderNoise, obeysNoFrameThatWasChangedOnTheWay) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    VehicleBench bench;
    ASSERT_TRUE(bench.open());
    Noise noise{seed};
    for (int i = 0; i < 500; ++i) {
      auto frame = bench.host.drive(400, noise.byte(), 255);
      frame[noise.below(static_cast<std::uint32_t>(frame.size() - 2))] ^=
          static_cast<std::uint8_t>(1 + noise.below(255));
      const std::uint16_t crc = wire::crc16(wire::Bytes{frame}.subspan(1, frame.size() - 3));
      frame[frame.size() - 2] = static_cast<std::uint8_t>(crc);
      frame[frame.size() - 1] = static_cast<std::uint8_t>(crc >> 8);
      bench.send(frame);
      bench.run(3);
    }
    bench.run(500);
    EXPECT_LT(std::hypot(bench.plant.x, bench.plant.y), 0.001) << seed;
  }
}

TEST(VehicleUnderNoise, startsFromAnEepromFullOfRubbish) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    VehicleBench bench;
    Noise noise{seed};
    for (auto& cell : bench.board.memory.cells) cell = noise.byte();
    bench.switchOn();
    bench.host = TestHost{kUncommissionedAddress, wire::Key{}};
    EXPECT_TRUE(bench.open()) << seed;
  }
}

}  // namespace
}  // namespace tessera::firmware::test
