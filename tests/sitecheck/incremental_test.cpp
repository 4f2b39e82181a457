// After any edits the verdict is that of a full check, and an edit runs only what it can concern.
#include <gtest/gtest.h>

#include "floor/new_floor.h"
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

// A floor of several hundred tiles with a slanting zone and routes all over it, so that most of it is far from an edit.
Site largeFloor() {
  Site site = floor::layNewFloor({"Large", floor::usualTileTypes().front(), 30, 20, true}).value();
  site.zones.push_back(
      zone("slant", floor::ZoneKind::Running, {at(-1.1, 0.3), at(19.7, -2.2), at(17.3, 13.1), at(2.4, 11.7)}));
  for (int i = 0; i < 6; ++i)
    site.routes.push_back({"R" + std::to_string(i), {at(0.5, 0.7 + 1.9 * i), at(17.2, 0.6 + 1.8 * i)}, Metres{0.2}});
  return site;
}

// Edits of some tiles as the editor makes them: moved, turned, taken up, laid, deleted, laid again where they were.
class TileEditor {
public:
  TileEditor(Site& site, std::mt19937_64& random) : site_{site}, random_{random} {}
  void edit() {
    const std::size_t count = random_() % 20 == 0 ? 200 : 1 + random_() % 5;
    switch (random_() % 8) {
      case 0:
        return forSome(count, [&](floor::Placement& p) { p.origin = p.origin + Offset{step(), step()}; });
      case 1:
        return forSome(count, [&](floor::Placement& p) { p.quarterTurns = static_cast<int>(random_() % 4); });
      case 2:
        return forSome(count, [&](floor::Placement& p) { p.origin = at(18 * share(), 12 * share()); });
      case 3:
        for (std::size_t n = 0; n < count && !site_.placements.empty(); ++n) {
          taken_.push_back({random_() % site_.placements.size(), {}});
          taken_.back().second = site_.placements[taken_.back().first];
          site_.placements.erase(site_.placements.begin() + static_cast<std::ptrdiff_t>(taken_.back().first));
        }
        return;
      case 4:
        // Each back to where it stood in the list, as a step that is undone.
        for (std::size_t n = 0; n < count && !taken_.empty(); ++n) {
          const auto [at, placement] = taken_.back();
          taken_.pop_back();
          site_.placements.insert(
              site_.placements.begin() + static_cast<std::ptrdiff_t>(std::min(at, site_.placements.size())), placement);
        }
        return;
      case 5:
        for (std::size_t n = 0; n < count; ++n) {
          const std::string serial = "N-" + std::to_string(++laid_);
          site_.tiles.push_back({serial, site_.tileTypes.front().name, {}});
          if (random_() % 30 == 0) site_.tiles.back().uids = site_.tiles[random_() % site_.tiles.size()].uids;
          site_.placements.push_back({serial, at(18 * share(), 12 * share()), 0});
        }
        return;
      case 6:
        for (std::size_t n = 0; n < count && site_.tiles.size() > 1; ++n) {
          const std::size_t tile = site_.tiles.size() - 1 - random_() % std::min<std::size_t>(site_.tiles.size(), 9);
          if (random_() % 8 != 0)
            std::erase_if(site_.placements, [&](const auto& p) { return p.serial == site_.tiles[tile].serial; });
          site_.tiles.erase(site_.tiles.begin() + static_cast<std::ptrdiff_t>(tile));
        }
        return;
      default:
        if (random_() % 3 == 0) return editAtRandom(site_, random_);
        return forSome(1, [&](floor::Placement& p) { p.origin = p.origin + Offset{Metres{0.002}, Metres{}}; });
    }
  }

private:
  template <class Change>
  void forSome(std::size_t count, Change change) {
    for (std::size_t n = 0; n < count && !site_.placements.empty(); ++n)
      change(site_.placements[random_() % site_.placements.size()]);
  }
  double share() { return std::uniform_real_distribution<double>{0.0, 1.0}(random_); }
  Metres step() { return Metres{0.1 * (share() - 0.5)}; }

  Site& site_;
  std::mt19937_64& random_;
  std::vector<std::pair<std::size_t, floor::Placement>> taken_;
  int laid_ = 0;
};

TEST(SiteChecker, findsAfterEveryEditOfSomeTilesWhatAFullCheckFinds) {
  std::size_t faults = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    std::mt19937_64 random{seed};
    Site site = seed % 4 == 0 ? goodFloor() : largeFloor();
    TileEditor editor{site, random};
    SiteChecker checker;
    checker.check(kept(site));
    for (int step = 0; step < 30; ++step) {
      editor.edit();
      const Verdict& verdict = checker.check(kept(site));
      ASSERT_EQ(verdict, checkSite(site)) << "seed " << seed << ", step " << step << "\n" << listOf(verdict.faults());
      faults += verdict.size();
    }
  }
  EXPECT_GT(faults, 5000U) << "the edits break something";
}

TEST(SiteChecker, movingATileAsksOnlyTheRoutesThatPassIt) {
  Site site = largeFloor();
  SiteChecker checker;
  checker.check(kept(site));
  site.placements[1].origin.x += Metres{0.01};  // at the first route
  checker.check(kept(site));
  EXPECT_EQ(checker.runs(), 6U + 1U) << "the checks of tiles, one route's tags: no floor is bare that was not";
  site.placements[598].origin.x += Metres{0.5};  // in the last corner, off every route
  checker.check(kept(site));
  EXPECT_EQ(checker.runs(), 6U + 2U) << "and the gaps of both zones, but no route";
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
