// After any edits the verdict is that of a full check, and an edit runs only what it can concern.
#include <gtest/gtest.h>

#include "floor/random_site.h"
#include "floor/site_json.h"
#include "sitecheck/sites.h"

namespace tessera::sitecheck {
namespace {

using floor::Site;

std::shared_ptr<const Site> kept(Site site) { return std::make_shared<const Site>(std::move(site)); }

TEST(SiteChecker, findsAfterEveryEditWhatAFullCheckFinds) {
  std::size_t faults = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::mt19937_64 random{seed};
    Site site = goodFloor();
    SiteChecker checker;
    for (int step = 0; step < 60; ++step) {
      editAtRandom(site, random);
      const Verdict& verdict = checker.check(kept(site));
      ASSERT_EQ(verdict, checkSite(site)) << "seed " << seed << ", step " << step << "\n" << listOf(verdict.faults());
      faults += verdict.size();
    }
  }
  EXPECT_GT(faults, 5000U) << "the edits break something";
}

TEST(SiteChecker, findsTheSameOnSitesOfEveryShape) {
  SiteChecker checker;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Site site = floor::randomSite(seed);
    ASSERT_EQ(checker.check(kept(site)), checkSite(site)) << seed;
  }
}

TEST(SiteChecker, callsAnErrorWhateverAMapRefuses) {
  std::size_t refused = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    std::mt19937_64 random{seed};
    Site site = seed % 2 == 0 ? goodFloor() : floor::randomSite(seed);
    for (int step = 0; step < 15; ++step) {
      editAtRandom(site, random);
      const auto map = floor::SiteMap::build(site);
      if (map) continue;
      ++refused;
      ASSERT_GT(checkSite(site).count(Severity::Error), 0U) << map.error().sentence;
    }
  }
  EXPECT_GT(refused, 100U);
}

TEST(SiteChecker, asksNothingAgainWhereNothingChanged) {
  SiteChecker checker;
  checker.check(kept(goodFloor()));
  EXPECT_GT(checker.runs(), 10U);
  checker.check(kept(goodFloor()));
  EXPECT_EQ(checker.runs(), 0U);
}

TEST(SiteChecker, anEditOfOneRouteAsksForThatRouteAlone) {
  Site site = goodFloor();
  for (int i = 0; i < 50; ++i) site.routes.push_back({"R" + std::to_string(i), {at(0.5, 0.5), at(2, 2)}, Metres{0.2}});
  SiteChecker checker;
  checker.check(kept(site));
  site.routes[7].vertices[1] = at(2, 1.5);
  checker.check(kept(site));
  EXPECT_EQ(checker.runs(), 3U) << "their names, its way, its tags";
  site.routes.erase(site.routes.begin());
  checker.check(kept(site));
  EXPECT_EQ(checker.runs(), 1U) << "their names";
}

TEST(SiteChecker, registeringATagDoesNotLookAtZonesOrWays) {
  Site site = goodFloor();
  SiteChecker checker;
  checker.check(kept(site));
  site.tiles[3].uids[2] = {};
  checker.check(kept(site));
  EXPECT_EQ(checker.runs(), 4U) << "twins, UIDs, registration, the route's tags";
}

TEST(SiteChecker, movingAParkingZoneDoesNotLookForGapsInTheFloor) {
  Site site = goodFloor();
  site.zones.push_back(zone("P", floor::ZoneKind::Parking, rectangle(0, 0, 1, 1)));
  SiteChecker checker;
  checker.check(kept(site));
  site.zones[1].outline[2] = at(1.2, 1.2);
  checker.check(kept(site));
  EXPECT_EQ(checker.runs(), 5U + 1U + 1U) << "the checks of zones, its own gaps, the route's way";
}

TEST(SiteChecker, theSitesThatComeWithTheProgramHaveNoFaults) {
  for (const char* name : {"paper", "three"}) {
    const auto site = floor::loadSite(std::string{TESSERA_SITES} + "/" + name + ".tessera.json");
    ASSERT_TRUE(site);
    EXPECT_EQ(listOf(checkSite(*site).faults()), "") << name;
  }
  EXPECT_EQ(listOf(checkSite(goodFloor()).faults()), "");
}

TEST(SiteChecker, keepsTheSiteOfAMapAlive) {
  SiteChecker checker;
  auto map = floor::SiteMap::build(goodFloor()).value();
  checker.check(siteOf(map));
  map.reset();
  Site site = goodFloor();
  site.name = "other";
  checker.check(kept(site));
  EXPECT_EQ(checker.runs(), 0U);
}

}  // namespace
}  // namespace tessera::sitecheck
