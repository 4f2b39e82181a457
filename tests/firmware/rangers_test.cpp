#include "firmware/vehicle/rangers.h"

#include <gtest/gtest.h>

#include "tests/firmware/fake_board.h"

namespace tessera::firmware::test {
namespace {

std::uint32_t echoOf(double metres) { return static_cast<std::uint32_t>(metres * 5800.0); }

struct RangerBench {
  FakeBoard board;
  Rangers rangers{board};

  RangerBench() { rangers.configure(0.30F); }
  void run(std::uint64_t us) {
    for (const std::uint64_t end = board.time + us; board.time < end; board.time += 10'000)
      rangers.tick(Micros{static_cast<std::int64_t>(board.time)});
  }
};

TEST(Rangers, pingEachOtherRangerMoreThanSixtyMillisecondsApart) {
  RangerBench bench;
  bench.run(1'000'000);
  for (const auto& pings : bench.board.pings) {
    EXPECT_GE(pings.size(), 11U);
    for (std::size_t i = 1; i < pings.size(); ++i) EXPECT_GT(pings[i] - pings[i - 1], 60'000U);
  }
}

TEST(Rangers, seeNothingWithNothingInReach) {
  RangerBench bench;
  bench.run(2'000'000);
  EXPECT_FALSE(bench.rangers.obstacle());
  EXPECT_EQ(bench.rangers.nearestCm(), 255);
  EXPECT_FALSE(bench.rangers.faulty());
}

TEST(Rangers, tellTheDistanceToTheNearest) {
  RangerBench bench;
  bench.board.echoes = {echoOf(1.5), echoOf(0.805)};
  bench.run(1'000'000);
  EXPECT_EQ(bench.rangers.nearestCm(), 80);
  EXPECT_FALSE(bench.rangers.obstacle());
}

TEST(Rangers, stopWithinHalfASecondOfAnObstacle) {
  RangerBench bench;
  bench.run(1'000'000);
  bench.board.echoes[1] = echoOf(0.25);
  bench.run(400'000);
  EXPECT_TRUE(bench.rangers.obstacle());
}

TEST(Rangers, believeNoSingleOutlier) {
  RangerBench bench;
  bench.board.echoes = {echoOf(1.0), echoOf(1.0)};
  bench.run(1'000'000);
  for (int i = 0; i < 20; ++i) {
    bench.board.echoes[0] = echoOf(0.1);
    bench.run(80'000);
    bench.board.echoes[0] = echoOf(1.0);
    bench.run(320'000);
    EXPECT_FALSE(bench.rangers.obstacle());
  }
}

TEST(Rangers, goOnOnlyAfterASecondOfFreeWayAndFiveCentimetresMore) {
  RangerBench bench;
  bench.board.echoes[0] = echoOf(0.25);
  bench.run(1'000'000);
  bench.board.echoes[0] = echoOf(0.33);
  bench.run(3'000'000);
  EXPECT_TRUE(bench.rangers.obstacle()) << "not far enough";
  bench.board.echoes[0] = echoOf(0.40);
  bench.run(1'000'000);
  EXPECT_TRUE(bench.rangers.obstacle()) << "not long enough";
  bench.run(600'000);
  EXPECT_FALSE(bench.rangers.obstacle());
}

TEST(Rangers, neverStopWithAStopDistanceOfZero) {
  RangerBench bench;
  bench.rangers.configure(0.0F);
  bench.board.echoes[0] = echoOf(0.05);
  bench.run(1'000'000);
  EXPECT_FALSE(bench.rangers.obstacle());
  bench.board.echoes[0] = 0;
  bench.run(1'000'000);
  EXPECT_TRUE(bench.rangers.faulty());
  EXPECT_FALSE(bench.rangers.obstacle());
}

TEST(Rangers, takeThePulseOfAnUnansweredPingForFreeSpace) {
  RangerBench bench;
  bench.board.echoes = {38'000, 38'000};
  bench.run(1'000'000);
  EXPECT_EQ(bench.rangers.nearestCm(), 255);
}

TEST(Rangers, sayThatALineIsStuck) {
  RangerBench bench;
  bench.board.echoes[1] = 20;
  bench.run(2'000'000);
  EXPECT_TRUE(bench.rangers.faulty());
  EXPECT_TRUE(bench.rangers.obstacle());
  EXPECT_EQ(bench.rangers.nearestCm(), 255);
  bench.board.echoes[1] = echoOf(1.0);
  bench.run(1'200'000);
  EXPECT_FALSE(bench.rangers.faulty());
}

TEST(Rangers, tellOneThatGivesNoPulseFromFreeSpace) {
  RangerBench bench;
  bench.run(1'000'000);
  bench.board.echoes[1] = 0;
  bench.run(320'000);
  EXPECT_FALSE(bench.rangers.faulty()) << "four lost pulses are no dead ranger";
  bench.run(160'000);
  EXPECT_TRUE(bench.rangers.faulty());
  EXPECT_TRUE(bench.rangers.obstacle());
  EXPECT_EQ(bench.rangers.nearestCm(), 255);
  bench.board.echoes[1] = 38'000;
  bench.run(900'000);
  EXPECT_TRUE(bench.rangers.faulty()) << "not before a second of answers";
  EXPECT_TRUE(bench.rangers.obstacle());
  bench.run(300'000);
  EXPECT_FALSE(bench.rangers.faulty());
  EXPECT_FALSE(bench.rangers.obstacle());
}

TEST(Rangers, forgiveFourLostPulsesInARow) {
  RangerBench bench;
  bench.board.echoes = {echoOf(1.005), echoOf(1.005)};
  for (int i = 0; i < 10; ++i) {
    bench.board.echoes[0] = 0;
    bench.run(320'000);  // four pings
    EXPECT_FALSE(bench.rangers.faulty());
    bench.board.echoes[0] = echoOf(1.005);
    bench.run(160'000);
    EXPECT_EQ(bench.rangers.nearestCm(), 100);
  }
}

TEST(Rangers, keepAnObstacleBeforeOneThatIsAboutToBeGivenUp) {
  RangerBench bench;
  bench.board.echoes[0] = echoOf(0.255);
  bench.run(1'000'000);
  bench.board.echoes[0] = 0;
  bench.run(280'000);
  EXPECT_TRUE(bench.rangers.obstacle());
  EXPECT_EQ(bench.rangers.nearestCm(), 25);
  bench.run(200'000);
  EXPECT_TRUE(bench.rangers.obstacle());
  EXPECT_EQ(bench.rangers.nearestCm(), 255) << "nobody knows";
}

TEST(Rangers, waitASecondAnewAfterEachPingThatAFaultyOneLeavesUnanswered) {
  RangerBench bench;
  bench.board.echoes[0] = 0;
  bench.run(1'000'000);
  EXPECT_TRUE(bench.rangers.faulty());
  for (int i = 0; i < 5; ++i) {
    bench.board.echoes[0] = 38'000;
    bench.run(800'000);
    bench.board.echoes[0] = 0;
    bench.run(80'000);
    EXPECT_TRUE(bench.rangers.faulty());
  }
  bench.board.echoes[0] = 38'000;
  bench.run(1'200'000);
  EXPECT_FALSE(bench.rangers.faulty());
}

TEST(Rangers, giveEachPingsPulseTheTimeUntilTheNext) {
  RangerBench bench;
  bench.run(1'000'000);
  for (const auto& pings : bench.board.pings)
    for (std::size_t i = 1; i < pings.size(); ++i) EXPECT_EQ(pings[i] - pings[i - 1], 80'000U);
  EXPECT_EQ(bench.board.pings[0][0] - bench.board.pings[1][0], 40'000U);
}

}  // namespace
}  // namespace tessera::firmware::test
