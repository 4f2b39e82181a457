#include "sitediff/difference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "floor/random_site.h"
#include "floor/route_legs.h"
#include "sitecheck/sites.h"

namespace tessera::sitediff {
namespace {

using floor::Site;
using sitecheck::at;
using sitecheck::goodFloor;
using testing::HasSubstr;

template <class Edit>
Change only(Edit edit) {
  Site after = goodFloor();
  edit(after);
  const Changes changes = difference(goodFloor(), after);
  EXPECT_EQ(changes.size(), 1U) << (changes.empty() ? "" : changes.back().sentence.english());
  return changes.empty() ? Change{} : changes.front();
}

TEST(Difference, ofASiteToItselfIsEmpty) {
  EXPECT_TRUE(difference(goodFloor(), goodFloor()).empty());
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Site site = floor::randomSite(seed);
    EXPECT_TRUE(difference(site, site).empty()) << seed;
  }
}

TEST(Difference, passesOverTheOrderOfLists) {
  Site after = goodFloor();
  std::reverse(after.tiles.begin(), after.tiles.end());
  std::reverse(after.placements.begin(), after.placements.end());
  EXPECT_TRUE(difference(goodFloor(), after).empty());
}

TEST(Difference, isEmptyForEqualSitesAlone) {
  std::mt19937_64 random{3};
  for (int round = 0; round < 400; ++round) {
    Site before = goodFloor();
    for (int i = 0; i < 3; ++i) sitecheck::editAtRandom(before, random);
    Site after = before;
    sitecheck::editAtRandom(after, random);
    EXPECT_EQ(difference(before, after).empty(), before == after) << round;
    EXPECT_EQ(difference(after, before).empty(), before == after) << round;
  }
}

TEST(Difference, countsTheSameBothWays) {
  const auto count = [](const Changes& changes, ChangeKind kind) {
    return std::count_if(changes.begin(), changes.end(), [kind](const Change& c) { return c.kind == kind; });
  };
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Site a = floor::randomSite(seed);
    const Site b = floor::randomSite(seed + 1);
    EXPECT_EQ(count(difference(a, b), ChangeKind::Added), count(difference(b, a), ChangeKind::Removed)) << seed;
  }
}

TEST(Difference, ofTilesSaysWhereTheyGo) {
  Change change = only([](Site& s) { s.placements[3].origin = at(9, 9); });
  EXPECT_EQ(change.kind, ChangeKind::Moved);
  EXPECT_EQ(change.sentence, "Tile \"T-0004\" moves from (1.80, 0.00) to (9.00, 9.00) m.");
  EXPECT_NEAR(change.place->high.x.value(), 9.0, 1e-9);
  change = only([](Site& s) { s.placements[3].quarterTurns = 1; });
  EXPECT_EQ(change.sentence, "Tile \"T-0004\" is turned from 0° to 90°.");
  change = only([](Site& s) { s.placements.pop_back(); });
  EXPECT_EQ(change.kind, ChangeKind::Removed);
  EXPECT_THAT(change.sentence.english(), HasSubstr("is taken up from (2.40, 1.80)"));
  change = only([](Site& s) { s.tiles.push_back({"new", s.tiles[0].type, {}}); });
  EXPECT_EQ(change.sentence, "Tile \"new\" is new.");
}

TEST(Difference, countsWhatHappensToATilesTags) {
  const Change change = only([](Site& s) {
    s.tiles[0].uids[0] = {};
    s.tiles[0].uids[1] = floor::TagUid::parse("04AABBCC").value();
    s.tiles[0].uids[2] = floor::TagUid::parse("04AABBCD").value();
  });
  EXPECT_EQ(change.sentence, "Tile \"T-0001\": tags registered: 0, cleared: 1, replaced: 2.");
}

TEST(Difference, namesTheLegWhoseSpeedIsAnother) {
  Site slow = goodFloor();
  setLegSpeed(slow.routes[0], 0, MetresPerSecond{0.2});
  Site slower = slow;
  setLegSpeed(slower.routes[0], 0, MetresPerSecond{0.05});
  const auto sentence = [](const Site& a, const Site& b) { return difference(a, b).at(0).sentence.english(); };
  EXPECT_EQ(sentence(slow, slower), "Route \"round\": at most 0.050 m/s instead of 0.200 m/s on leg 1.");
  EXPECT_EQ(sentence(slow, goodFloor()), "Route \"round\": no highest speed on leg 1 any more.");
  insertVertex(slower.routes[0], 1, at(1, 0.4));
  EXPECT_EQ(difference(slow, slower).size(), 2U);
  EXPECT_EQ(difference(slow, slower)[1].sentence, "Route \"round\": other highest speeds on its legs.");
}

TEST(Difference, ofZonesRoutesAndVehicles) {
  Change change = only([](Site& s) {
    for (Point& p : s.zones[0].outline) p = p + Offset{Metres{1}, {}};
  });
  EXPECT_EQ(change.kind, ChangeKind::Moved);
  change = only([](Site& s) { s.zones[0].outline[1] = at(8, 8); });
  EXPECT_EQ(change.sentence, "Zone \"Floor\": another outline.");
  change = only([](Site& s) { s.zones[0].kind = floor::ZoneKind::NoGo; });
  EXPECT_EQ(change.sentence, "Zone \"Floor\": kind \"no-go\" instead of \"running\".");
  change = only([](Site& s) { s.routes[0].vertices.pop_back(); });
  EXPECT_EQ(change.sentence, "Route \"round\": another way, 3.80 m instead of 6.00 m.");
  change = only([](Site& s) { setLegSpeed(s.routes[0], 1, MetresPerSecond{0.1}); });
  EXPECT_EQ(change.sentence, "Route \"round\": at most 0.100 m/s on leg 2.");
  EXPECT_NEAR(change.place->low.x.value(), 2.6, 1e-9);
  change = only([](Site& s) { s.vehicles[0].key[3] = 1; });
  EXPECT_EQ(change.sentence, "Vehicle \"AGV 1\": another key.") << "and not which";
  change = only([](Site& s) { s.vehicles[0].track = Metres{0.5}; });
  EXPECT_EQ(change.name, "1");
  change = only([](Site& s) { s.radio.channel = 5; });
  EXPECT_EQ(change.subject, Subject::Radio);
  change = only([](Site& s) {
    s.backdrop = floor::Backdrop{"hall.png", std::make_shared<const std::string>("bytes"), {}, {}, {}, 0.5};
  });
  EXPECT_EQ(change.sentence, "Floor plan \"hall.png\" is new.");
  EXPECT_EQ(codeOf(change.subject), "backdrop");
}

TEST(Difference, tellsOfThePictureBeneathWhatIsDifferent) {
  Site before = goodFloor();
  before.backdrop = floor::Backdrop{"hall.png", std::make_shared<const std::string>("bytes"), {}, {}, {}, 0.5};
  const auto told = [&before](auto edit) {
    Site after = before;
    edit(after);
    std::string all;
    for (const Change& change : difference(before, after)) all += change.sentence.english() + "\n";
    return all;
  };
  EXPECT_EQ(told([](Site& s) { s.backdrop->picture = std::make_shared<const std::string>("bytes"); }), "")
      << "the same bytes elsewhere in memory";
  EXPECT_EQ(told([](Site& s) { s.backdrop->picture = std::make_shared<const std::string>("other"); }),
            "Floor plan \"hall.png\": another picture.\n");
  EXPECT_EQ(told([](Site& s) {
              s.backdrop->origin = at(1, 2);
              s.backdrop->pixel = Metres{0.05};
              s.backdrop->opacity = 1.0;
            }),
            "Floor plan \"hall.png\" moves from (0.00, 0.00) to (1.00, 2.00) m.\n"
            "Floor plan \"hall.png\": another scale or direction.\nFloor plan \"hall.png\": another opacity.\n");
  EXPECT_EQ(told([](Site& s) { s.backdrop.reset(); }), "Floor plan \"hall.png\" is gone.\n");
}

}  // namespace
}  // namespace tessera::sitediff
