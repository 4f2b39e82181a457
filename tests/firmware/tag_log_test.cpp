#include "firmware/vehicle/tag_log.h"

#include <gtest/gtest.h>

namespace tessera::firmware::test {
namespace {

using wire::EventKind;

struct LogBench {
  TagLog log;
  Micros now{10s};
  std::array<std::uint8_t, 8> counters{};

  // One attempt of a reader, 100 ms after the last; uid 0 = no tag.
  void attempt(std::uint8_t reader, std::uint8_t uid, std::uint8_t length = 7) {
    now += 100ms;
    Reading r;
    r.reader = reader;
    r.counter = ++counters[reader];
    r.length = uid == 0 ? std::uint8_t{0} : length;
    r.uid[0] = uid;
    log.take(r, now);
  }
  wire::Report report() {
    wire::Report r;
    log.fill(r, now);
    return r;
  }
};

TEST(TagLog, reportsATagOnceWithItsAge) {
  LogBench bench;
  bench.attempt(1, 42);
  bench.attempt(1, 42);
  bench.attempt(1, 42);
  const auto r = bench.report();
  ASSERT_EQ(r.eventCount, 1);
  EXPECT_EQ(r.events[0].kind, EventKind::Uid7);
  EXPECT_EQ(r.events[0].reader, 1);
  EXPECT_EQ(r.events[0].uid[0], 42);
  EXPECT_EQ(r.events[0].age, 20);
}

TEST(TagLog, saysThatATagHasLeftAfterThreeMissesWithTheAgeOfTheLastRead) {
  LogBench bench;
  bench.attempt(0, 42);
  bench.attempt(0, 0);
  bench.attempt(0, 0);
  EXPECT_EQ(bench.log.waiting(), 1U);
  bench.attempt(0, 42);
  for (int i = 0; i < 3; ++i) bench.attempt(0, 0);
  const auto r = bench.report();
  ASSERT_EQ(r.eventCount, 2);
  EXPECT_EQ(r.events[1].kind, EventKind::Left);
  EXPECT_EQ(r.events[1].age, 30);
}

TEST(TagLog, saysThatATagHasLeftWhenAnotherComes) {
  LogBench bench;
  bench.attempt(0, 1);
  bench.attempt(0, 2, 4);
  EXPECT_EQ(bench.log.waiting(), 3U);
  bench.log.acknowledge(0);
  const auto r = bench.report();
  ASSERT_EQ(r.eventCount, 3);
  EXPECT_EQ(r.events[1].kind, EventKind::Left);
  EXPECT_EQ(r.events[2].kind, EventKind::Uid4);
}

TEST(TagLog, passesOverAnAnswerThatItHasSeen) {
  LogBench bench;
  bench.attempt(0, 1);
  Reading same;
  same.counter = bench.counters[0];
  for (int i = 0; i < 5; ++i) bench.log.take(same, bench.now);
  EXPECT_EQ(bench.log.waiting(), 1U) << "an old answer is no miss";
}

TEST(TagLog, keepsEventsUntilTheHostHasThem) {
  LogBench bench;
  bench.attempt(0, 1);
  bench.attempt(1, 2);
  EXPECT_EQ(bench.report().eventCount, 2);
  EXPECT_EQ(bench.report().eventCount, 2);
  bench.log.acknowledge(1);
  const auto r = bench.report();
  EXPECT_EQ(r.firstEvent, 1);
  EXPECT_EQ(r.eventCount, 1);
  bench.log.acknowledge(200);
  EXPECT_EQ(bench.log.waiting(), 1U) << "a number that was never reported acknowledges nothing";
}

TEST(TagLog, reportsAsManyAsFitAndTheRestLater) {
  LogBench bench;
  for (std::uint8_t i = 1; i <= 5; ++i) bench.attempt(i, i, 10);
  const auto first = bench.report();
  EXPECT_EQ(first.eventCount, 2) << "26 bytes hold two UIDs of ten bytes";
  bench.log.acknowledge(2);
  const auto second = bench.report();
  EXPECT_EQ(second.firstEvent, 2);
  EXPECT_EQ(second.events[0].uid[0], 3);
  std::array<std::uint8_t, wire::kMaxPayload> out;
  EXPECT_GT(encode(second, out), 0U);
}

TEST(TagLog, dropsTheOldestWhenNobodyFetchesAndSaysSoOnce) {
  LogBench bench;
  for (int i = 0; i < 20; ++i) bench.attempt(0, static_cast<std::uint8_t>(i + 1));
  EXPECT_EQ(bench.log.waiting(), TagLog::kCapacity);
  EXPECT_TRUE(bench.log.lost());
  const auto r = bench.report();
  EXPECT_EQ(r.firstEvent, 39 - 32);
  EXPECT_FALSE(bench.log.lost());
}

TEST(TagLog, numbersEventsModulo256) {
  LogBench bench;
  std::uint8_t next = 0;
  for (int i = 0; i < 300; ++i) {
    bench.attempt(0, static_cast<std::uint8_t>(i % 2 + 1));
    const auto r = bench.report();
    EXPECT_EQ(r.firstEvent, next);
    next = static_cast<std::uint8_t>(next + r.eventCount);
    bench.log.acknowledge(next);
  }
  EXPECT_EQ(bench.log.waiting(), 0U);
  EXPECT_FALSE(bench.log.lost());
}

TEST(TagLog, tellsANewHostWhatLiesUnderTheReaders) {
  LogBench bench;
  bench.attempt(2, 9);
  EXPECT_EQ(bench.report().eventCount, 1);
  bench.log.acknowledge(1);
  bench.log.beginSession(bench.now);
  bench.log.acknowledge(0);
  const auto r = bench.report();
  ASSERT_EQ(r.eventCount, 1);
  EXPECT_EQ(r.firstEvent, 1);
  EXPECT_EQ(r.events[0].uid[0], 9);
}

TEST(TagLog, bearsReadersThatItDoesNotKnow) {
  LogBench bench;
  Reading r;
  r.reader = 15;
  r.length = 7;
  bench.log.take(r, bench.now);
  EXPECT_EQ(bench.log.waiting(), 0U);
}

}  // namespace
}  // namespace tessera::firmware::test
