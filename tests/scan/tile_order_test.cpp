// A tile's tags are read in another order than they are registered in: exchanged, read anew, taken back.
#include <random>

#include "scan/scan_walk.h"

namespace tessera::scan {
namespace {

TEST_F(ScanWalk, asksAboutATagOfTheSameTileAndExchangesTheTwo) {
  for (unsigned n = 0; n < 16; ++n) scan(n);
  const floor::Site before = map->site();
  const std::string serial = nameOf(map->site(), person->walk()[0]).serial;
  person.emplace(map, Course{WalkOrder::TilesAlongFloor, serial, true, {}, {}});
  const auto first = here();
  EXPECT_EQ(scan(5), Verdict::OnThisTile);
  EXPECT_EQ(last.where, nameOf(map->site(), person->walk()[5]));
  EXPECT_EQ(here(), first) << "it is asked first";
  exchange(5);
  EXPECT_EQ(uidAt(map->site(), person->walk()[0]), uid(5));
  EXPECT_EQ(uidAt(map->site(), person->walk()[5]), uid(0));
  EXPECT_EQ(here(), nameOf(map->site(), person->walk()[1]));
  EXPECT_EQ(scan(5), Verdict::Repeated) << "it lies on the reader still";
  EXPECT_EQ(scan(9), Verdict::InUse) << "a tag of another tile is none to exchange";
  EXPECT_TRUE(person->exchange(uid(9)).empty());
  EXPECT_TRUE(person->exchange(uid(99)).empty());
  back();
  EXPECT_EQ(here(), first);
  EXPECT_EQ(map->site(), before);
}

TEST_F(ScanWalk, movesATagOfTheSameTileToAnOpenPlace) {
  scan(1);
  const auto second = here();
  scan(2);
  ASSERT_EQ(scan(1), Verdict::OnThisTile);
  const auto third = here();
  exchange(1);
  EXPECT_EQ(uidAt(map->site(), person->walk()[2]), uid(1));
  EXPECT_TRUE(uidAt(map->site(), person->walk()[0]).empty());
  EXPECT_EQ(registered(), 2U);
  back();
  EXPECT_EQ(here(), third);
  EXPECT_EQ(uidAt(map->site(), person->walk()[0]), uid(1));
  back();
  EXPECT_EQ(here(), second);
}

TEST_F(ScanWalk, readsATileAnewInAnotherOrderAndGoesOnAfterTheProgramDied) {
  for (unsigned n = 0; n < 3; ++n) scan(n);
  person->skip();
  for (unsigned n = 4; n < 7; ++n) scan(n);
  const auto eighth = here();
  const floor::Site before = map->site();
  ASSERT_EQ(scan(0), Verdict::OnThisTile);
  readAnew();
  EXPECT_EQ(registered(), 0U);
  EXPECT_EQ(person->progress().skipped, 0U) << "the dead one may lie elsewhere";
  EXPECT_EQ(here(), nameOf(map->site(), person->walk()[0]));
  now += Seconds{0.3};
  EXPECT_EQ(person->offer({uid(0), {}}, now).verdict, Verdict::Repeated) << "it lies on the reader still";
  EXPECT_EQ(scan(0), Verdict::Accepted) << "held to the lit place";
  for (unsigned n = 7; n > 4; --n) ASSERT_EQ(scan(n), Verdict::Accepted);
  const auto place = here();
  const Course kept = person->course();
  for (int n = 0; n < 4; ++n) back();
  EXPECT_EQ(registered(), 0U);
  back();
  EXPECT_EQ(map->site(), before);
  EXPECT_EQ(here(), eighth);
  EXPECT_EQ(person->progress().skipped, 1U);

  readAnew();
  for (const unsigned n : {0U, 7U, 6U, 5U}) scan(n);
  person.emplace(map, kept);
  EXPECT_EQ(here(), place);
  for (unsigned n = 4; n > 0; --n) ASSERT_EQ(scan(n), Verdict::Accepted);
}

TEST_F(ScanWalk, goesBackWhereExchangingOrReadingAnewIsUndone) {
  for (unsigned n = 0; n < 3; ++n) scan(n);
  const auto place = here();
  const auto three = map;
  ASSERT_EQ(scan(0), Verdict::OnThisTile);
  readAnew();
  EXPECT_NE(here(), place);
  map = three;
  person->siteChanged(three);
  EXPECT_EQ(here(), place);
  exchange(0);
  EXPECT_NE(here(), place);
  map = three;
  person->siteChanged(three);
  EXPECT_EQ(here(), place);
}

TEST_F(ScanWalk, goesBackOverWhateverWasDoneStepByStep) {
  const auto fresh = map;
  int exchanged = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    std::mt19937_64 random{seed};
    map = fresh;
    person.emplace(map, Course{static_cast<WalkOrder>(seed % 3), seed % 4 == 0 ? "T-0002" : "", seed % 4 == 0, {}, {}});
    std::vector<std::pair<floor::Site, Course>> before;
    for (int i = 0; i < 40 && person->stop() != nullptr; ++i) {
      const auto was = std::pair{map->site(), person->course()};
      const auto n = static_cast<unsigned>(random() % 24);
      bool stepped = true;
      if (random() % 6 == 0) {
        person->skip();
      } else if (const Verdict verdict = scan(n); verdict == Verdict::OnThisTile) {
        if (random() % 3 == 0) {
          readAnew();
        } else {
          exchange(n);
        }
        ++exchanged;
      } else {
        stepped = verdict == Verdict::Accepted || verdict == Verdict::Confirmed;
      }
      if (stepped) before.push_back(was);
    }
    for (; !before.empty(); before.pop_back()) {
      back();
      ASSERT_EQ(map->site().tiles.size(), before.back().first.tiles.size());
      for (const Stop& stop : person->walk())
        ASSERT_EQ(uidAt(map->site(), stop), uidAt(before.back().first, stop)) << seed;
      ASSERT_EQ(person->course(), before.back().second) << seed;
    }
  }
  EXPECT_GT(exchanged, 60);
}

}  // namespace
}  // namespace tessera::scan
