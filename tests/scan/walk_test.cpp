// Properties of the walk on regular, untidy and random floors.
#include "scan/walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "floor/new_floor.h"
#include "floor/random_site.h"
#include "floor/site_map.h"

namespace tessera::scan {
namespace {

constexpr WalkOrder kOrders[] = {WalkOrder::TilesAlongFloor, WalkOrder::TilesByNumber, WalkOrder::RowsOfTags};

floor::Site floorOf(int columns, int rows) {
  return floor::layNewFloor({"f", floor::usualTileTypes().front(), columns, rows, false}).value();
}

std::size_t placesOf(const floor::Site& site, bool laidOnly) {
  std::map<std::string, std::size_t> tags;
  for (const auto& type : site.tileTypes) tags.try_emplace(type.name, tagOffsets(type).size());
  std::set<std::string> laid;
  for (const auto& p : site.placements) laid.insert(p.serial);
  std::size_t count = 0;
  for (const auto& tile : site.tiles)
    if ((!laidOnly || laid.contains(tile.serial)) && tags.contains(tile.type)) count += tags[tile.type];
  return count;
}

/// Tiles a few centimetres beside their places and turned, as hands lay them.
floor::Site untidy(std::uint64_t seed) {
  std::mt19937_64 random{seed};
  const auto upTo = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  floor::Site site = floorOf(1 + upTo(6), 1 + upTo(5));
  for (auto& p : site.placements) {
    const int turns = upTo(4);
    const Offset back[] = {{}, {Metres{0.6}, {}}, {Metres{0.6}, Metres{0.6}}, {{}, Metres{0.6}}};
    p.origin = p.origin + back[turns] + Offset{Metres{0.001 * upTo(20)}, Metres{0.001 * upTo(20)}};
    p.quarterTurns = turns;
  }
  std::shuffle(site.tiles.begin(), site.tiles.end(), random);
  std::shuffle(site.placements.begin(), site.placements.end(), random);
  if (!site.placements.empty() && upTo(2) == 0) site.placements.pop_back();
  return site;
}

void expectEachOnce(const floor::Site& site) {
  for (const WalkOrder order : kOrders) {
    const auto walk = walkOver(site, order);
    std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
    for (const Stop& stop : walk) seen.emplace(stop.tile, stop.tag);
    ASSERT_EQ(seen.size(), walk.size()) << "a place twice";
    ASSERT_EQ(walk.size(), placesOf(site, order != WalkOrder::TilesByNumber));
    ASSERT_EQ(walkOver(site, order), walk);
  }
}

TEST(Walk, visitsEachPlaceJustOnceInEveryOrder) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) expectEachOnce(untidy(seed));
}

TEST(Walk, takesSitesOfAnyShape) {
  std::size_t whole = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const auto map = floor::SiteMap::build(floor::randomSite(seed));
    if (!map) continue;
    ++whole;
    expectEachOnce((*map)->site());
  }
  EXPECT_GT(whole, 5U);
}

TEST(Walk, makesNoStepLongerThanATileOnAFloorWithoutGaps) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    floor::Site site = untidy(seed);
    if (site.placements.size() != site.tiles.size()) continue;
    for (const WalkOrder order : {WalkOrder::TilesAlongFloor, WalkOrder::RowsOfTags}) {
      const auto walk = walkOver(site, order);
      for (std::size_t i = 1; i < walk.size(); ++i)
        ASSERT_LE(distance(*walk[i - 1].place, *walk[i].place), Metres{1.25}) << seed << ", step " << i;
    }
  }
}

TEST(Walk, finishesATileBeforeTheNextAndTurnsAtTheEndOfARow) {
  const auto site = floorOf(3, 2);
  std::vector<std::string> serials;
  for (const Stop& stop : walkOver(site, WalkOrder::TilesAlongFloor)) {
    const std::string& serial = site.tiles[stop.tile].serial;
    if (serials.empty() || serials.back() != serial) serials.push_back(serial);
  }
  EXPECT_EQ(serials, (std::vector<std::string>{"T-0001", "T-0002", "T-0003", "T-0006", "T-0005", "T-0004"}));
}

TEST(Walk, goesAlongTheFloorRowByRow) {
  const auto site = floorOf(2, 1);
  const auto walk = walkOver(site, WalkOrder::RowsOfTags);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(walk[i].place->y.value(), 0.075, 1e-9);
    EXPECT_NEAR(walk[4 + i].place->y.value(), 0.225, 1e-9);
    if (i == 0) continue;
    EXPECT_LT(walk[i - 1].place->x, walk[i].place->x);
    EXPECT_GT(walk[3 + i].place->x, walk[4 + i].place->x);
  }
}

TEST(Walk, keepsToOneTileWhereOneIsAskedForLaidOrNot) {
  auto site = floorOf(2, 2);
  for (const WalkOrder order : kOrders) {
    const auto walk = walkOver(site, order, "T-0003");
    EXPECT_EQ(walk.size(), 8U);
    EXPECT_TRUE(std::all_of(walk.begin(), walk.end(), [](const Stop& s) { return s.tile == 2 && s.place; }));
  }
  site.placements.clear();
  for (const WalkOrder order : kOrders) EXPECT_EQ(walkOver(site, order, "T-0003").size(), 8U);
  EXPECT_TRUE(walkOver(site, WalkOrder::RowsOfTags).empty());
  EXPECT_TRUE(walkOver(site, WalkOrder::RowsOfTags, "nobody").empty());
}

TEST(Walk, isTheSameWhateverIsRegistered) {
  auto site = floorOf(2, 2);
  auto other = site;
  other.tiles[0].uids = {floor::TagUid::parse("04A1B2C3").value()};
  EXPECT_TRUE(samePlaces(site, other));
  EXPECT_EQ(walkOver(site, WalkOrder::RowsOfTags), walkOver(other, WalkOrder::RowsOfTags));
  other.placements[1].quarterTurns = 1;
  EXPECT_FALSE(samePlaces(site, other));
}

}  // namespace
}  // namespace tessera::scan
