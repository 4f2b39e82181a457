#include "firmware/vehicle/radio.h"

#include <gtest/gtest.h>

#include "tests/firmware/fake_board.h"

namespace tessera::firmware::test {
namespace {

struct RadioBench {
  FakeBoard board;
  Radio radio{board};
  std::vector<std::vector<std::uint8_t>> payloads;

  Micros now() const { return Micros{static_cast<std::int64_t>(board.time)}; }
  void start(const Settings& settings = {}) { radio.start(settings, now()); }
  void run(std::uint64_t us) {
    for (const std::uint64_t end = board.time + us; board.time < end; board.time += 500)
      radio.poll(now(), [&](const wire::Frame& f) { payloads.emplace_back(f.payload.begin(), f.payload.end()); });
  }
  void arrive(wire::Bytes bytes) { board.incoming[0].insert(board.incoming[0].end(), bytes.begin(), bytes.end()); }
};

std::vector<std::uint8_t> frameWith(std::initializer_list<std::uint8_t> payload) {
  const std::vector<std::uint8_t> p{payload};
  std::vector<std::uint8_t> out(wire::kMaxFrame);
  out.resize(wire::encodeFrame({1, 0, 2, 3}, p, out));
  return out;
}

TEST(Radio, writesTheModulesRegistersWhenTheyDiffer) {
  RadioBench bench;
  bench.start();
  bench.run(300'000);
  EXPECT_TRUE(bench.radio.talking());
  EXPECT_FALSE(bench.radio.faulty());
  EXPECT_EQ(bench.board.e32.writes, 1);
  EXPECT_EQ(bench.board.e32.registers, (std::array<std::uint8_t, 6>{0xC0, 0, 0, 0x3D, 23, 0x44}));
  EXPECT_EQ(bench.board.mode, RadioMode::Normal);
  EXPECT_EQ(bench.board.baud[0], 115200U);
}

TEST(Radio, leavesRegistersAloneThatAreRight) {
  RadioBench bench;
  bench.board.e32.registers = radioRegisters({});
  bench.start();
  bench.run(100'000);
  EXPECT_TRUE(bench.radio.talking());
  EXPECT_EQ(bench.board.e32.writes, 0);
}

TEST(Radio, triesAgainWithAModuleThatTookNoParametersWhileItHearsNothing) {
  RadioBench bench;
  bench.board.e32.present = false;
  bench.start();
  bench.run(2'000'000);
  EXPECT_TRUE(bench.radio.faulty());
  bench.board.e32.present = true;
  for (int second = 0; second < 12; ++second) {
    bench.arrive(frameWith({1, 2, 3}));
    bench.run(1'000'000);
  }
  EXPECT_TRUE(bench.radio.faulty()) << "it is heard: let it talk";
  EXPECT_EQ(bench.payloads.size(), 12U);
  bench.run(6'000'000);
  EXPECT_FALSE(bench.radio.faulty());
  EXPECT_TRUE(bench.radio.talking());
  EXPECT_EQ(bench.board.e32.registers, radioRegisters({}));
  EXPECT_EQ(bench.board.baud[0], 115200U);
}

TEST(Radio, saysThatAModuleTakesNoParametersButTalksAllTheSame) {
  for (const bool present : {true, false}) {
    RadioBench bench;
    bench.board.e32.stubborn = true;
    bench.board.e32.present = present;
    bench.start();
    bench.run(2'000'000);
    EXPECT_TRUE(bench.radio.faulty());
    EXPECT_TRUE(bench.radio.talking());
    bench.arrive(frameWith({1, 2, 3}));
    bench.run(2'000);
    EXPECT_EQ(bench.payloads.size(), 1U);
  }
}

TEST(Radio, doesNotHangOnAModuleThatIsNeverReady) {
  RadioBench bench;
  bench.board.aux = false;
  bench.start();
  bench.run(5'000'000);
  EXPECT_TRUE(bench.radio.talking());
  EXPECT_FALSE(bench.radio.canSend());
}

TEST(Radio, forgetsAHalfFrameAfterSilenceAndTakesTheNextOne) {
  RadioBench bench;
  bench.start();
  bench.run(300'000);
  const auto frame = frameWith({7, 8, 9});
  bench.arrive(wire::Bytes{frame}.first(6));
  bench.run(30'000);
  bench.arrive(frame);
  bench.run(2'000);
  ASSERT_EQ(bench.payloads.size(), 1U);
  EXPECT_EQ(bench.payloads[0], (std::vector<std::uint8_t>{7, 8, 9}));
}

TEST(Radio, keepsAFrameTogetherThatComesInPieces) {
  RadioBench bench;
  bench.start();
  bench.run(300'000);
  const auto frame = frameWith({7, 8, 9});
  bench.arrive(wire::Bytes{frame}.first(6));
  bench.run(10'000);
  bench.arrive(wire::Bytes{frame}.subspan(6));
  bench.run(1'000);
  EXPECT_EQ(bench.payloads.size(), 1U);
}

TEST(Radio, sendsWholeFramesOnlyWhenTheModuleIsIdle) {
  RadioBench bench;
  const auto frame = frameWith({1});
  EXPECT_FALSE(bench.radio.send(frame)) << "not configured yet";
  bench.start();
  bench.run(300'000);
  bench.board.aux = false;
  EXPECT_FALSE(bench.radio.send(frame));
  EXPECT_TRUE(bench.board.outgoing[0].empty());
  bench.board.aux = true;
  EXPECT_TRUE(bench.radio.send(frame));
  EXPECT_EQ(bench.board.outgoing[0], frame);
  const std::vector<std::uint8_t> tooLong(wire::kMaxFrame + 1);
  EXPECT_FALSE(bench.radio.send(tooLong));
  EXPECT_EQ(bench.board.outgoing[0].size(), frame.size());
}

TEST(Radio, countsDamagedFrames) {
  RadioBench bench;
  bench.start();
  bench.run(300'000);
  auto frame = frameWith({1, 2, 3});
  frame[8] ^= 1;
  bench.arrive(frame);
  bench.run(100'000);
  EXPECT_EQ(bench.radio.damagedFrames(), 1U);
  EXPECT_TRUE(bench.payloads.empty());
}

}  // namespace
}  // namespace tessera::firmware::test
