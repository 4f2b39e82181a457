#include "sim/reader_row.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/test_floor.h"

namespace tessera::sim {
namespace {

constexpr double kBatteryVolts = 12.345;
const std::vector<Offset> kHeads{
    {Metres{0.15}, Metres{0.10}}, {Metres{0.15}, Metres{0.0}}, {Metres{0.15}, Metres{-0.10}}};

std::shared_ptr<const floor::SiteMap> mapOf(const floor::Site& site) {
  auto map = floor::SiteMap::build(site);
  EXPECT_TRUE(map) << map.error().sentence;
  return *map;
}

struct Row {
  std::shared_ptr<const floor::SiteMap> map = mapOf(testSite(40));
  ReaderRow row;
  Seconds now;
  Pose pose{{Metres{3.0}, Metres{3.0}}, Radians{0.0}};

  explicit Row(const ReaderParameters& parameters = {}, std::uint64_t seed = 1)
      : row{parameters, kHeads, map, seed, 7} {}
  void step() {
    now += Seconds{0.001};
    row.step(now, pose, kBatteryVolts);
  }
  void run(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) step();
  }
  /// Puts the given reader's head over a place.
  void place(std::size_t reader, Point over) {
    pose = {{over.x - kHeads[reader].x, over.y - kHeads[reader].y}, Radians{}};
  }
  /// Asks a node and returns what comes within 10 ms.
  std::vector<std::uint8_t> ask(std::uint8_t node) {
    const auto first = static_cast<std::uint8_t>(0xB0U | node);
    const std::array<std::uint8_t, 2> poll{first, static_cast<std::uint8_t>(~first)};
    row.receive(poll, now);
    std::vector<std::uint8_t> answer;
    for (int i = 0; i < 10; ++i) {
      step();
      const auto bytes = row.take(now);
      answer.insert(answer.end(), bytes.begin(), bytes.end());
    }
    return answer;
  }
};

std::uint8_t sumOf(const std::vector<std::uint8_t>& bytes) {
  std::uint8_t sum = 0;
  for (const std::uint8_t byte : bytes) sum ^= byte;
  return sum;
}

TEST(ReaderRow, seesATagAboutAQuarterOfTheTimeOnTheOneInTwoFloor) {
  Row r;
  RandomStream places{3, "places"};
  int seen = 0;
  int tries = 0;
  while (tries < 30000) {
    r.pose = {{Metres{places.between(1.0, 5.0)}, Metres{places.between(1.0, 5.0)}}, Radians{places.between(-3, 3)}};
    const std::uint64_t before = r.row.attempts(0);
    while (r.row.attempts(0) == before) {
      r.now += Seconds{0.01};
      r.row.step(r.now, r.pose, kBatteryVolts);
    }
    // The attempt that has just ended asked the floor at this pose or the one before: both are random places.
    for (std::size_t i = 0; i < 3; ++i, ++tries)
      if (!r.row.lastRead(i).empty()) ++seen;
  }
  // Density 1/(2 g²) times the disc's area, a little more by the soft edge, times the detection: 0.231.
  const double area = kPi * (0.06 * 0.06 + kPi * kPi / 3 * 0.005 * 0.005);
  EXPECT_NEAR(static_cast<double>(seen) / tries, 0.9 * area / (2 * 0.15 * 0.15), 0.012);
}

TEST(ReaderRow, readsNineTimesOutOfTenOverATagAndHalfAsOftenAtTheEdge) {
  const auto share = [](double away) {
    Row r;
    r.place(1, r.map->tags()[300].place + Offset{Metres{away}, Metres{}});
    int seen = 0;
    for (int i = 0; i < 2000; ++i) {
      const std::uint64_t before = r.row.attempts(1);
      while (r.row.attempts(1) == before) r.step();
      if (r.row.lastRead(1) == r.map->tags()[300].uid) ++seen;
    }
    return seen / 2000.0;
  };
  EXPECT_NEAR(share(0.0), 0.9, 0.03);
  EXPECT_NEAR(share(0.06), 0.45, 0.04);
  EXPECT_EQ(share(0.10), 0.0);
}

TEST(ReaderRow, triesTenTimesASecond) {
  Row r;
  r.run(60'000);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(static_cast<double>(r.row.attempts(i)), 600.0, 8.0);
}

TEST(ReaderRow, takesTheNearestOfSeveralTags) {
  Row r;
  ReaderParameters wide;
  wide.radius = Metres{0.25};
  wide.detection = 1.0;
  ReaderRow row{wide, kHeads, r.map, 1, 7};
  r.place(1, r.map->tags()[300].place + Offset{Metres{0.03}, Metres{0.01}});
  for (int i = 0; i < 500; ++i) row.step(Seconds{0.001 * i}, r.pose, kBatteryVolts);
  EXPECT_EQ(row.lastRead(1), r.map->tags()[300].uid);
}

TEST(ReaderRow, answersAPollWithCounterAndUid) {
  Row r;
  r.place(1, r.map->tags()[300].place);
  while (r.row.lastRead(1).empty()) r.step();
  const auto answer = r.ask(1);
  ASSERT_EQ(answer.size(), 8U);
  EXPECT_EQ(answer[0], 0xD1);
  EXPECT_EQ(answer[1], 4);
  EXPECT_EQ(answer[2], static_cast<std::uint8_t>(r.row.attempts(1)));
  const auto uid = r.map->tags()[300].uid.bytes();
  EXPECT_TRUE(std::equal(uid.begin(), uid.end(), answer.begin() + 3));
  EXPECT_EQ(sumOf(answer), 0);
}

TEST(ReaderRow, answersWithoutUidWhereNoTagIs) {
  Row r;
  r.pose = {{Metres{100.0}, Metres{100.0}}, Radians{}};
  r.run(300);
  const auto answer = r.ask(0);
  ASSERT_EQ(answer.size(), 4U);
  EXPECT_EQ(answer[0], 0xD0);
  EXPECT_EQ(answer[1], 0);
  EXPECT_EQ(sumOf(answer), 0);
}

TEST(ReaderRow, answersAtThePaceOfTheBus) {
  Row r;
  r.run(300);
  const std::array<std::uint8_t, 2> poll{0xBF, 0x40};
  r.row.receive(poll, r.now);
  // The second byte of the poll, 0.5 ms, then the answer's six bytes.
  const Seconds byteTime{10.0 / 38400};
  const Seconds first = r.now + byteTime + Seconds{0.0005} + byteTime;
  EXPECT_TRUE(r.row.take(first - Seconds{1e-5}).empty());
  EXPECT_EQ(r.row.take(first + Seconds{1e-5}).size(), 1U);
  EXPECT_EQ(r.row.take(first + 5 * byteTime + Seconds{1e-5}).size(), 5U);
}

TEST(ReaderRow, tellsTheBatterysVoltage) {
  Row r;
  r.step();
  const auto answer = r.ask(15);
  ASSERT_EQ(answer.size(), 6U);
  EXPECT_EQ(answer[0], 0xDF);
  EXPECT_EQ(answer[3] | answer[4] << 8, 12345);
  EXPECT_EQ(sumOf(answer), 0);
}

TEST(ReaderRow, keepsSilentForNobodyForADeadReaderAndForABadPoll) {
  Row r;
  r.run(300);
  EXPECT_TRUE(r.ask(3).empty());
  r.row.setDead(2, true);
  EXPECT_TRUE(r.ask(2).empty());
  r.row.setDead(2, false);
  EXPECT_FALSE(r.ask(2).empty());
  const std::array<std::uint8_t, 3> bad{0xB0, 0xB0, 0x12};
  r.row.receive(bad, r.now);
  r.run(10);
  EXPECT_TRUE(r.row.take(r.now).empty());
}

TEST(ReaderRow, losesAnAnswerThatIsTalkedOver) {
  Row r;
  r.run(300);
  const std::array<std::uint8_t, 4> twice{0xB0, 0x4F, 0xB1, 0x4E};
  r.row.receive(twice, r.now);
  r.run(10);
  EXPECT_LT(r.row.take(r.now).size(), 4U);
}

TEST(ReaderRow, neverReadsADeadTag) {
  Row r;
  r.place(1, r.map->tags()[300].place);
  r.row.setDeadTag(r.map->tags()[300].uid, true);
  for (int i = 0; i < 5000; ++i) {
    r.step();
    ASSERT_TRUE(r.row.lastRead(1).empty());
  }
}

}  // namespace
}  // namespace tessera::sim
