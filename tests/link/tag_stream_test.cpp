#include "link/tag_stream.h"

#include <gtest/gtest.h>

namespace tessera::link {
namespace {

// A report with events numbered from `first`, whose first UID byte is the number.
wire::Report reportOf(std::uint8_t first, std::uint8_t count, std::uint8_t age = 0) {
  wire::Report r;
  r.firstEvent = first;
  r.eventCount = count;
  for (std::uint8_t i = 0; i < count; ++i) {
    r.events[i].kind = wire::EventKind::Uid4;
    r.events[i].age = age;
    r.events[i].uid[0] = static_cast<std::uint8_t>(first + i);
  }
  return r;
}

std::vector<int> numbers(const TagStream::Taken& taken) {
  std::vector<int> found;
  for (const TimedTagEvent& t : taken.fresh) found.push_back(t.event.uid[0]);
  return found;
}

TEST(TagStream, dropsWhatItHasAlready) {
  TagStream stream;
  EXPECT_EQ(numbers(stream.take(reportOf(0, 3), Seconds{1})), (std::vector{0, 1, 2}));
  const auto again = stream.take(reportOf(1, 4), Seconds{2});
  EXPECT_EQ(numbers(again), (std::vector{3, 4}));
  EXPECT_EQ(again.lost, 0U);
  EXPECT_TRUE(stream.take(reportOf(0, 5), Seconds{3}).fresh.empty());
  EXPECT_EQ(stream.next(), 5);
}

TEST(TagStream, countsAGap) {
  TagStream stream;
  (void)stream.take(reportOf(0, 2), Seconds{1});
  const auto after = stream.take(reportOf(7, 1), Seconds{2});
  EXPECT_EQ(after.lost, 5U);
  EXPECT_EQ(numbers(after), (std::vector{7}));
}

TEST(TagStream, goesOnAcrossTheWrap) {
  TagStream stream;
  (void)stream.take(reportOf(250, 4), Seconds{1});
  EXPECT_EQ(numbers(stream.take(reportOf(253, 5), Seconds{2})), (std::vector{254, 255, 0, 1}));
  EXPECT_EQ(stream.next(), 2);
}

TEST(TagStream, takesTheFirstNumbersOfAStartAsTheyCome) {
  TagStream stream;
  const auto first = stream.take(reportOf(40, 2), Seconds{1});
  EXPECT_EQ(first.lost, 0U);
  EXPECT_EQ(numbers(first), (std::vector{40, 41}));
  stream.restart();
  EXPECT_EQ(stream.next(), 0);
  EXPECT_EQ(numbers(stream.take(reportOf(0, 1), Seconds{2})), (std::vector{0}));
}

TEST(TagStream, turnsAgesIntoInstants) {
  TagStream stream;
  const auto taken = stream.take(reportOf(0, 1, 25), Seconds{10});
  EXPECT_NEAR(taken.fresh[0].at.value(), 9.75, 1e-9);
  EXPECT_FALSE(taken.fresh[0].older);
  EXPECT_TRUE(stream.take(reportOf(1, 1, 255), Seconds{11}).fresh[0].older);
}

}  // namespace
}  // namespace tessera::link
