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

TEST(SiteMap, refusesPlacesThatAreNoNumbers) {
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e300}) {
    Site site = oneTile();
    site.placements[0].origin.x = Metres{bad};
    EXPECT_THAT(refusal(site), HasSubstr("04000001")) << bad;
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
