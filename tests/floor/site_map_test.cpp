// The map against the publication's formula, against brute force, and against sites that contradict themselves.
#include "floor/site_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

namespace tessera::floor {
namespace {

using ::testing::HasSubstr;

Point at(double x, double y) { return {Metres{x}, Metres{y}}; }

TagUid uid(unsigned n) {
  const std::array<std::uint8_t, 4> bytes{4, static_cast<std::uint8_t>(n >> 16), static_cast<std::uint8_t>(n >> 8),
                                          static_cast<std::uint8_t>(n)};
  return *TagUid::fromBytes(bytes);
}

// One 2 x 1 tile "A" with two tags at (0.1, 0.2) and (0.3, 0.2).
Site oneTile() {
  Site site;
  site.tileTypes = {
      {"2x1", Metres{0.4}, Metres{0.4}, Metres{0.2}, {Metres{0.1}, Metres{0.2}}, 2, 1, Pattern::Full, false, {}}};
  site.tiles = {{"A", "2x1", {uid(1), uid(2)}}};
  site.placements = {{"A", at(5, 7), 0}};
  return site;
}

std::string refusal(const Site& site) {
  const auto map = SiteMap::build(site);
  return map ? "" : map.error().sentence;
}

TEST(SiteMap, placesATagAtOriginPlusTurnedOffset) {
  const std::array<Point, 4> expected{at(5.1, 7.2), at(4.8, 7.1), at(4.9, 6.8), at(5.2, 6.9)};
  for (int turns = 0; turns < 4; ++turns) {
    Site site = oneTile();
    site.placements[0].quarterTurns = turns;
    const auto map = *SiteMap::build(site);
    const Point place = *map->find(uid(1));
    const Offset l{Metres{0.1}, Metres{0.2}};
    EXPECT_NEAR(distance(place, at(5, 7) + turned(l, fromDegrees(90 * turns))).value(), 0.0, 1e-12);
    EXPECT_NEAR(distance(place, expected[static_cast<std::size_t>(turns)]).value(), 0.0, 1e-12);
  }
}

TEST(SiteMap, quarterTurnsAreExact) {
  Site site = oneTile();
  site.placements[0] = {"A", at(0, 0), 1};
  EXPECT_EQ((*SiteMap::build(site))->find(uid(1)), at(-0.2, 0.1));
}

TEST(SiteMap, findsOnlyWhatIsRegisteredAndLaid) {
  Site site = oneTile();
  site.tiles.push_back({"not laid", "2x1", {uid(3)}});
  site.tiles[0].uids[1] = TagUid{};
  site.looseTags = {{uid(9), at(1, 1)}};
  const auto map = *SiteMap::build(site);
  EXPECT_EQ(map->tags().size(), 2U);
  EXPECT_TRUE(map->find(uid(1)));
  EXPECT_FALSE(map->find(uid(2)));
  EXPECT_FALSE(map->find(uid(3)));
  EXPECT_FALSE(map->find(TagUid{}));
  EXPECT_EQ(map->find(uid(9)), at(1, 1));
}

TEST(SiteMap, anEmptySiteHasNoTags) {
  const auto map = *SiteMap::build({});
  EXPECT_FALSE(map->find(uid(1)));
  map->forEachNear(at(0, 0), Metres{1e9}, [](const PlacedTag&) { FAIL(); });
}

TEST(SiteMap, namesTheUidAtTwoPlaces) {
  Site site = oneTile();
  site.tiles[0].uids[1] = uid(1);
  EXPECT_THAT(refusal(site), HasSubstr("04000001"));
  site = oneTile();
  site.looseTags = {{uid(2), at(0, 0)}};
  EXPECT_THAT(refusal(site), HasSubstr("04000002"));
}

TEST(SiteMap, refusesWhatIsAmbiguous) {
  Site site = oneTile();
  site.placements.push_back({"A", at(1, 1), 0});
  EXPECT_THAT(refusal(site), HasSubstr("\"A\" is laid twice"));
  site = oneTile();
  site.placements.push_back({"B", at(1, 1), 0});
  EXPECT_THAT(refusal(site), HasSubstr("\"B\" is laid, but no such tile"));
  site = oneTile();
  site.tiles[0].type = "3x3";
  EXPECT_THAT(refusal(site), HasSubstr("\"3x3\""));
  site = oneTile();
  site.tiles[0].uids.push_back(uid(3));
  EXPECT_THAT(refusal(site), HasSubstr("3 UIDs"));
  site = oneTile();
  site.tiles.push_back(site.tiles[0]);
  EXPECT_THAT(refusal(site), HasSubstr("Two tiles"));
  site = oneTile();
  site.tileTypes.push_back(site.tileTypes[0]);
  EXPECT_THAT(refusal(site), HasSubstr("Two tile types"));
  site = oneTile();
  site.routes.resize(2);
  EXPECT_THAT(refusal(site), HasSubstr("Two routes"));
  site = oneTile();
  site.vehicles.resize(2);
  EXPECT_THAT(refusal(site), HasSubstr("Two vehicles"));
}

std::vector<std::string> carriedContradictions(const Site& site) {
  std::vector<std::string> all;
  const auto map = *SiteMap::build(site, Ambiguity::Carried);
  for (const Contradiction& c : map->contradictions()) all.push_back(c.sentence.english());
  return all;
}

TEST(SiteMap, carriesWhatItRefusesForMendingAndSaysAllOfIt) {
  EXPECT_TRUE((*SiteMap::build(oneTile()))->contradictions().empty());
  EXPECT_TRUE((*SiteMap::build(oneTile(), Ambiguity::Carried))->contradictions().empty());
  EXPECT_TRUE((*SiteMap::build(oneTile(), Ambiguity::Carried))->find(uid(2)));
  Site site = oneTile();
  site.tileTypes.push_back(site.tileTypes[0]);
  site.tiles.push_back({"A", "2x1", {uid(3)}});
  site.tiles.push_back({"C", "3x3", {}});
  site.tiles.push_back({"D", "2x1", {{}, {}, uid(4)}});
  for (const char* serial : {"B", "C", "D"}) site.placements.push_back({serial, at(1, 1), 0});
  site.placements.push_back({"B", at(2, 2), 0});
  site.looseTags = {{uid(1), at(0, 0)}, {uid(1), at(1, 0)}, {uid(9), at(2, 0)}};
  site.routes.resize(2);
  site.vehicles.resize(3);
  EXPECT_THAT(carriedContradictions(site),
              ::testing::UnorderedElementsAre(
                  HasSubstr("Two tile types"), HasSubstr("Two tiles have the serial number \"A\""),
                  HasSubstr("\"B\" is laid twice"), HasSubstr("\"B\" is laid, but"), HasSubstr("\"B\" is laid, but"),
                  HasSubstr("\"3x3\""), HasSubstr("\"D\" has 3 UIDs"), HasSubstr("04000001"), HasSubstr("04000001"),
                  HasSubstr("Two routes"), HasSubstr("address 0"), HasSubstr("address 0")));
  const auto map = *SiteMap::build(site, Ambiguity::Carried);
  EXPECT_EQ(map->site(), site);
  EXPECT_EQ(map->tags().size(), 1U) << "what is ambiguous is no tag";
  EXPECT_TRUE(map->find(uid(9)));
  EXPECT_FALSE(SiteMap::build(site)) << "unless it is asked for";
}

TEST(SiteMap, locatesByNeitherPlaceOfADoubledUid) {
  Site site = oneTile();
  site.looseTags = {{uid(2), at(0, 0)}};
  const auto map = *SiteMap::build(site, Ambiguity::Carried);
  EXPECT_FALSE(map->find(uid(2)));
  map->forEachNear(at(0, 0), Metres{0.5}, [](const PlacedTag&) { FAIL(); });
  EXPECT_TRUE(map->find(uid(1))) << "the tile's other tag is as good as before";
}

TEST(SiteMap, isMendedStepByStepButNotMadeWorse) {
  Site broken = oneTile();
  broken.looseTags = {{uid(1), at(0, 0)}, {uid(2), at(1, 0)}};
  const auto before = *SiteMap::build(broken, Ambiguity::Carried);
  Site better = broken;
  better.looseTags.erase(better.looseTags.begin());
  const auto half = SiteMap::rebuild(better, *before, {broken, better});
  ASSERT_TRUE(half) << half.error().sentence;
  EXPECT_EQ((*half)->contradictions().size(), 1U);
  EXPECT_TRUE((*half)->find(uid(1)));
  Site worse = better;
  worse.routes.resize(2);
  const auto refused = SiteMap::rebuild(worse, **half, {better, worse});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().sentence.english(), HasSubstr("Two routes"));
  Site renamed = better;  // an edit that leaves the tags alone does not lose sight of what is wrong with them
  renamed.name = "other";
  EXPECT_EQ((*SiteMap::rebuild(renamed, **half, {better, renamed}))->contradictions().size(), 1U);
  Site good = better;
  good.looseTags.clear();
  const auto mended = SiteMap::rebuild(good, **half, {better, good});
  ASSERT_TRUE(mended);
  EXPECT_TRUE((*mended)->contradictions().empty());
  EXPECT_FALSE(SiteMap::rebuild(better, **mended, {good, better})) << "good again: strict again";
  EXPECT_TRUE(SiteMap::rebuild(better, **mended, {good, better}, Ambiguity::Carried)) << "but for undo";
}

TEST(SiteMap, findsWhatOneContradictionHidesBeforeItIsMended) {
  Site site = oneTile();
  site.placements.push_back({"A", at(1, 1), 0});
  site.looseTags = {{uid(1), at(0, 0)}};
  const auto before = *SiteMap::build(site, Ambiguity::Carried);
  Site after = site;
  after.placements.pop_back();
  const auto mended = SiteMap::rebuild(after, *before, {site, after});
  ASSERT_TRUE(mended) << mended.error().sentence;
  EXPECT_EQ((*mended)->contradictions().size(), 1U);
}

TEST(SiteMap, refusesPlacesThatAreNoNumbers) {
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e300}) {
    Site site = oneTile();
    site.placements[0].origin.x = Metres{bad};
    EXPECT_THAT(refusal(site), HasSubstr("04000001")) << bad;
    EXPECT_FALSE(SiteMap::build(site, Ambiguity::Carried)) << bad;
  }
}

TEST(SiteMap, findsRoutesAndVehiclesByName) {
  Site site;
  site.routes = {{"paper", {at(0, 0), at(1, 0)}, Metres{0.2}}};
  site.vehicles.resize(1);
  site.vehicles[0].id = VehicleId{7};
  const auto map = *SiteMap::build(site);
  ASSERT_NE(map->route("paper"), nullptr);
  EXPECT_EQ(map->route("paper"), &map->site().routes[0]);
  EXPECT_EQ(map->route("other"), nullptr);
  EXPECT_NE(map->vehicle(VehicleId{7}), nullptr);
  EXPECT_EQ(map->vehicle(VehicleId{8}), nullptr);
}

struct Spread {
  double width;
  double height;
  unsigned tags;
};

class Floors : public ::testing::TestWithParam<Spread> {};

TEST_P(Floors, nearTagsAreThoseOfBruteForceInTheSameOrder) {
  const auto [width, height, tags] = GetParam();
  std::mt19937_64 random{tags};
  std::uniform_real_distribution<double> x{-width / 3, width};
  std::uniform_real_distribution<double> y{-height / 3, height};
  Site site;
  for (unsigned n = 0; n < tags; ++n) site.looseTags.push_back({uid(n), at(x(random), y(random))});
  const auto map = *SiteMap::build(site);
  ASSERT_EQ(map->tags().size(), tags);
  std::exponential_distribution<double> radius{3.0 / width};
  for (int round = 0; round < 300; ++round) {
    const Point centre = at(1.5 * x(random), 1.5 * y(random));
    const Metres r{round == 0 ? 0.0 : round == 1 ? 1e12 : radius(random)};
    std::vector<TagUid> expected;
    for (const PlacedTag& t : map->tags()) {
      if (distance(t.place, centre) <= r) expected.push_back(t.uid);
    }
    std::vector<TagUid> found;
    map->forEachNear(centre, r, [&](const PlacedTag& t) { found.push_back(t.uid); });
    ASSERT_EQ(found, expected) << "radius " << r.value();
  }
}

TEST_P(Floors, everyTagIsFoundAndNoOther) {
  const auto [width, height, tags] = GetParam();
  Site site;
  for (unsigned n = 0; n < tags; ++n) site.looseTags.push_back({uid(2 * n), at(n * width / tags, height)});
  const auto map = *SiteMap::build(site);
  for (unsigned n = 0; n < tags; ++n) {
    ASSERT_EQ(map->find(uid(2 * n)), at(n * width / tags, height));
    ASSERT_FALSE(map->find(uid(2 * n + 1)));
  }
}

INSTANTIATE_TEST_SUITE_P(OfEveryShape, Floors,
                         ::testing::Values(Spread{1.8, 1.8, 72}, Spread{60, 1, 900}, Spread{1, 90, 900},
                                           Spread{90'000, 90'000, 50}, Spread{40, 30, 20'000}, Spread{1, 1, 1}),
                         [](const auto& spread) { return "No" + std::to_string(spread.index); });

TEST(SiteMap, tagsAtJustTheRadiusAreNear) {
  Site site;
  for (unsigned n = 0; n < 900; ++n)
    site.looseTags.push_back({uid(n), at(0.075 + 0.15 * (n % 30), 0.075 + 0.15 * (n / 30))});
  const auto map = *SiteMap::build(site);
  for (const PlacedTag& centre : map->tags()) {
    for (int k = 1; k < 5; ++k) {
      std::size_t expected = 0;
      for (const PlacedTag& t : map->tags()) expected += distance(t.place, centre.place) <= Metres{0.15 * k} ? 1 : 0;
      std::size_t found = 0;
      map->forEachNear(centre.place, Metres{0.15 * k}, [&found](const PlacedTag&) { ++found; });
      ASSERT_EQ(found, expected);
    }
  }
}

TEST(SiteMap, bearsQuestionsThatAreNoNumbers) {
  const auto map = *SiteMap::build(oneTile());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  int seen = 0;
  const auto count = [&seen](const PlacedTag&) { ++seen; };
  map->forEachNear(at(5, 7), Metres{nan}, count);
  map->forEachNear(at(nan, 7), Metres{1}, count);
  map->forEachNear(at(5, 7), Metres{-1}, count);
  map->forEachNear(at(infinite, 7), Metres{1}, count);
  EXPECT_EQ(seen, 0);
  map->forEachNear(at(5, 7), Metres{infinite}, count);
  EXPECT_EQ(seen, 2);
}

}  // namespace
}  // namespace tessera::floor
