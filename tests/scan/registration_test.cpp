// A person's way over a floor: accepted, refused, skipped, taken back, interrupted.
#include <random>
#include <set>

#include "scan/scan_walk.h"

namespace tessera::scan {
namespace {

TEST_F(ScanWalk, registersTagAfterTagUntilNoneIsLeft) {
  const auto walk = person->walk();
  for (unsigned n = 0; n < 16; ++n) {
    ASSERT_EQ(here(), nameOf(map->site(), walk[n]));
    ASSERT_EQ(scan(n), Verdict::Accepted);
    EXPECT_EQ(uidAt(map->site(), walk[n]), uid(n));
  }
  EXPECT_EQ(person->stop(), nullptr);
  EXPECT_EQ(person->progress().left, 0U);
  EXPECT_EQ(scan(99), Verdict::Finished);
}

TEST_F(ScanWalk, ignoresTheCardThatWasJustAcceptedHoweverLongItLies) {
  scan(1);
  const auto place = here();
  for (int i = 0; i < 5; ++i) EXPECT_EQ(scan(1), Verdict::Repeated);
  EXPECT_EQ(here(), place);
  EXPECT_EQ(registered(), 1U);
}

TEST_F(ScanWalk, refusesATagInUseAndNamesItsPlace) {
  for (unsigned n = 1; n <= 8; ++n) scan(n);
  EXPECT_EQ(scan(1), Verdict::InUse);
  ASSERT_TRUE(last.where);
  EXPECT_EQ(last.where->serial, "T-0001");
  EXPECT_EQ(last.sentence, "Tag 04000001 is registered already, as tag 1 of tile \"T-0001\".");
  EXPECT_EQ(registered(), 8U);
  auto site = map->site();
  site.looseTags = {{uid(0x77), {Metres{-1.5}, Metres{0.05}}}};
  map = floor::SiteMap::build(site).value();
  person->siteChanged(map);
  EXPECT_EQ(scan(0x77), Verdict::InUse);
  EXPECT_FALSE(last.where);
  EXPECT_EQ(last.sentence, "Tag 04000077 is registered already, as a loose tag at (-1.50, 0.05) m.");
}

TEST_F(ScanWalk, tellsARefusedCardThatStaysOnTheReaderOnce) {
  scan(1);
  scan(2);
  EXPECT_EQ(scan(1), Verdict::OnThisTile);
  for (int i = 0; i < 5; ++i) {
    now += Seconds{0.4};
    EXPECT_EQ(person->offer({uid(1), {}}, now).verdict, Verdict::Repeated);
  }
  EXPECT_EQ(scan(1), Verdict::OnThisTile) << "it was taken away and held there again";
}

TEST_F(ScanWalk, stepsBackOverRegisteredAndSkippedPlacesOneByOne) {
  const floor::Site before = map->site();
  const auto first = here();
  scan(1);
  const auto second = here();
  person->skip();
  const auto third = here();
  scan(2);
  back();
  EXPECT_EQ(here(), third);
  back();
  EXPECT_EQ(here(), second);
  EXPECT_EQ(person->progress().skipped, 0U);
  back();
  EXPECT_EQ(here(), first);
  EXPECT_EQ(registered(), 0U);
  back();
  EXPECT_EQ(here(), first) << "there is nothing before the first";
  EXPECT_EQ(scan(1), Verdict::Accepted) << "the card that was taken back is free again";
}

TEST_F(ScanWalk, goesBackWhereARegistrationIsUndoneAndOnWhereItIsRedone) {
  const auto empty = map;
  const auto first = here();
  scan(1);
  const auto second = here();
  const auto one = map;
  scan(2);
  const auto two = map;
  const auto third = here();
  map = one;
  person->siteChanged(one);
  EXPECT_EQ(here(), second);
  map = empty;
  person->siteChanged(empty);
  EXPECT_EQ(here(), first);
  map = one;
  person->siteChanged(one);
  EXPECT_EQ(here(), second);
  map = two;
  person->siteChanged(two);
  EXPECT_EQ(here(), third);
}

TEST_F(ScanWalk, leavesSkippedPlacesOutUntilTheyAreAskedFor) {
  const auto first = here();
  person->skip();
  for (unsigned n = 0; n < 15; ++n) ASSERT_EQ(scan(n), Verdict::Accepted);
  EXPECT_EQ(person->stop(), nullptr);
  EXPECT_EQ(person->progress().skipped, 1U);
  person->takeUpSkipped();
  EXPECT_EQ(here(), first);
  EXPECT_EQ(scan(50), Verdict::Accepted);
}

TEST_F(ScanWalk, comesBackAtTheEndToWhatWasPassedBy) {
  const auto first = here();
  EXPECT_TRUE(person->next());
  EXPECT_TRUE(person->next());
  EXPECT_TRUE(person->previous());
  for (unsigned n = 0; n < 15; ++n) ASSERT_EQ(scan(n), Verdict::Accepted);
  EXPECT_EQ(here(), first);
}

TEST_F(ScanWalk, goesOnWhereItStoodWithWhatWasSkipped) {
  scan(1);
  person->skip();
  scan(2);
  const auto place = here();
  const Course kept = person->course();
  Registration again{map, kept};
  EXPECT_EQ(nameOf(map->site(), *again.stop()), place);
  EXPECT_EQ(again.progress().skipped, 1U);
  EXPECT_EQ(again.course(), kept);
}

TEST_F(ScanWalk, registersOneTileAnewTagByTagThoughItHasAll) {
  for (unsigned n = 0; n < 16; ++n) scan(n);
  person.emplace(map, Course{WalkOrder::TilesAlongFloor, "T-0002", true, {}, {}});
  const auto first = here();
  EXPECT_EQ(scan(100), Verdict::Accepted);
  EXPECT_EQ(uidAt(map->site(), person->walk()[0]), uid(100));
  for (unsigned n = 101; n < 107; ++n) EXPECT_EQ(scan(n), Verdict::Accepted);
  const auto kept = uidAt(map->site(), person->walk()[7]);
  now += Seconds{5};
  EXPECT_EQ(person->offer({kept, {}}, now).verdict, Verdict::Confirmed);
  person->registered(map, kept, now);
  EXPECT_EQ(person->stop(), nullptr);
  for (int i = 0; i < 8; ++i) back();
  EXPECT_EQ(here(), first);
  EXPECT_EQ(uidAt(map->site(), person->walk()[0]).text(), uid(8).text()) << "what stood there before is back";
}

TEST_F(ScanWalk, believesATagThatSaysItLiesHereAndNotOneThatSaysElsewhere) {
  const Point place = *person->stop()->place;
  EXPECT_EQ(scan(1, place + Offset{Metres{0.03}, Metres{-0.03}}), Verdict::Accepted);
  const Stop other = person->walk()[12];
  EXPECT_EQ(scan(2, *other.place), Verdict::Elsewhere);
  EXPECT_EQ(last.where, nameOf(map->site(), other));
  EXPECT_EQ(scan(3, Point{Metres{50}, Metres{50}}), Verdict::Elsewhere);
  EXPECT_FALSE(last.where);
  EXPECT_EQ(registered(), 1U);
}

TEST_F(ScanWalk, tellsItsPaceWithoutThePauses) {
  for (unsigned n = 0; n < 4; ++n) scan(n);
  now += Seconds{3600};
  for (unsigned n = 4; n < 8; ++n) scan(n);
  const auto progress = person->progress();
  ASSERT_TRUE(progress.perTag);
  EXPECT_NEAR(progress.perTag->value(), 2.0, 1e-9);
  EXPECT_NEAR(progress.timeLeft->value(), 16.0, 1e-9);
}

TEST_F(ScanWalk, keepsItsPlaceWhenTilesAreEdited) {
  scan(1);
  const auto place = here();
  auto site = map->site();
  site.placements[1].origin.x += Metres{0.01};
  map = floor::SiteMap::build(site).value();
  person->siteChanged(map);
  EXPECT_EQ(here(), place);
  std::erase_if(site.placements, [](const auto& p) { return p.serial == "T-0001"; });
  map = floor::SiteMap::build(site).value();
  person->siteChanged(map);
  EXPECT_EQ(here().serial, "T-0002");
}

TEST_F(ScanWalk, neverRegistersAUidTwiceAndNeverLosesItsWayWhateverIsDone) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    std::mt19937_64 random{seed};
    map =
        floor::SiteMap::build(floor::layNewFloor({"f", floor::usualTileTypes().front(), 2, 2, false}).value()).value();
    person.emplace(map, Course{static_cast<WalkOrder>(seed % 3), {}, seed % 5 == 0, {}, {}});
    for (int i = 0; i < 120; ++i) {
      switch (random() % 9) {
        case 0:
          person->skip();
          break;
        case 1:
          back();
          break;
        case 2:
          (void)person->next();
          break;
        case 3:
          (void)person->previous();
          break;
        case 4:
          person.emplace(map, person->course());
          break;
        default:
          scan(static_cast<unsigned>(random() % 40));
      }
      std::set<floor::TagUid> seen;
      for (const auto& tile : map->site().tiles)
        for (const auto& u : tile.uids) ASSERT_TRUE(u.empty() || seen.insert(u).second);
      const auto p = person->progress();
      ASSERT_EQ(p.registered, seen.size());
      ASSERT_EQ(p.places, 32U);
    }
    person->takeUpSkipped();
    if (seed % 5 == 0) continue;
    for (unsigned n = 100; person->stop() != nullptr; ++n) {
      ASSERT_LT(n, 200U) << "it does not come to an end";
      scan(n);
    }
    EXPECT_EQ(person->progress().registered, 32U);
  }
}

}  // namespace
}  // namespace tessera::scan
