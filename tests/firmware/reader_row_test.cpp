#include "firmware/vehicle/reader_row.h"

#include <gtest/gtest.h>

#include "tests/firmware/fake_reader_bus.h"

namespace tessera::firmware::test {
namespace {

struct RowBench {
  FakeBoard board;
  FakeReaderBus bus;
  ReaderRow row{board};
  std::vector<Reading> readings;
  bool serve = true;

  explicit RowBench(int readers) { row.start(readers); }
  void run(std::uint64_t us) {
    for (const std::uint64_t end = board.time + us; board.time < end; board.time += 500) {
      if (const auto r = row.poll(Micros{static_cast<std::int64_t>(board.time)})) readings.push_back(*r);
      if (serve) bus.serve(board);
    }
  }
};

TEST(ReaderRow, asksAllReadersInTurnManyTimesASecond) {
  RowBench bench{3};
  for (std::uint8_t i = 0; i < 3; ++i) bench.bus.nodes[i].data = {i, 1, 2, 3};
  bench.run(1'000'000);
  for (std::uint8_t i = 0; i < 3; ++i) EXPECT_GE(bench.bus.polls[i], 50);
  EXPECT_EQ(bench.bus.polls[3], 0);
  EXPECT_EQ(bench.bus.malformed, 0);
  EXPECT_EQ(bench.row.answering(), 0b111);
  EXPECT_FALSE(bench.row.faulty());
  ASSERT_FALSE(bench.readings.empty());
  EXPECT_EQ(bench.readings[1].reader, 1);
  EXPECT_EQ(bench.readings[1].length, 4);
  EXPECT_EQ(bench.readings[1].uid[0], 1);
}

TEST(ReaderRow, takesUidsOfAllLengths) {
  RowBench bench{4};
  for (std::uint8_t i = 0; i < 4; ++i)
    bench.bus.nodes[i].data.assign(std::array<std::size_t, 4>{0, 4, 7, 10}[i], std::uint8_t{0xC3});
  bench.run(100'000);
  ASSERT_GE(bench.readings.size(), 4U);
  for (std::uint8_t i = 0; i < 4; ++i) EXPECT_EQ(bench.readings[i].length, (std::array{0, 4, 7, 10}[i]));
}

TEST(ReaderRow, namesAReaderThatIsMissingAndGoesOnWithTheOthers) {
  RowBench bench{3};
  bench.bus.nodes[0].data = {};
  bench.bus.nodes[2].data = {};
  bench.run(500'000);
  EXPECT_EQ(bench.row.answering(), 0b101);
  EXPECT_TRUE(bench.row.faulty());
  EXPECT_GE(bench.bus.polls[2], 20);
  bench.bus.nodes[1].data = {};
  bench.run(100'000);
  EXPECT_EQ(bench.row.answering(), 0b111);
  EXPECT_FALSE(bench.row.faulty());
}

TEST(ReaderRow, readsTheGaugeOnceASecond) {
  RowBench bench{1};
  bench.bus.setMillivolts(12'345);
  bench.run(3'100'000);
  EXPECT_EQ(bench.row.batteryMillivolts(), 12'345);
  EXPECT_GE(bench.bus.polls[15], 3);
  EXPECT_LE(bench.bus.polls[15], 4);
  bench.bus.nodes.erase(15);
  bench.run(4'000'000);
  EXPECT_EQ(bench.row.batteryMillivolts(), 0);
}

TEST(ReaderRow, believesNoDamagedAnswer) {
  RowBench bench{1};
  bench.serve = false;
  bench.run(10'000);
  auto bytes = FakeReaderBus::answerOf(0, {5, {1, 2, 3, 4}});
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    auto bad = bytes;
    bad[i] ^= 0x04;
    bench.board.incoming[1].assign(bad.begin(), bad.end());
    bench.run(20'000);
  }
  EXPECT_TRUE(bench.readings.empty());
}

TEST(ReaderRow, findsAnAnswerBehindNoise) {
  RowBench bench{1};
  bench.run(100'000);
  EXPECT_TRUE(bench.readings.empty());
  bench.serve = false;
  bench.board.takeOutgoing(Uart::Readers);
  while (bench.board.outgoing[1].empty()) bench.run(500);
  ASSERT_EQ(bench.board.outgoing[1][0], 0xB0);
  const auto good = FakeReaderBus::answerOf(0, {9, {1, 2, 3, 4}});
  bench.board.incoming[1] = {0x00, 0xFF, 0xD0, 0x33};
  for (std::uint8_t b : good) bench.board.incoming[1].push_back(b);
  bench.run(500);
  ASSERT_EQ(bench.readings.size(), 1U);
  EXPECT_EQ(bench.readings[0].counter, 9);
}

}  // namespace
}  // namespace tessera::firmware::test
