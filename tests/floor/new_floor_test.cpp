#include "floor/new_floor.h"

#include <gtest/gtest.h>

#include "floor/site_json.h"
#include "floor/site_map.h"

namespace tessera::floor {
namespace {

NewFloor wish(bool practice) { return {"Hall", usualTileTypes().front(), 3, 2, practice}; }

TEST(NewFloor, laysTilesSideBySideFromTheOrigin) {
  const auto site = layNewFloor(wish(false)).value();
  ASSERT_EQ(site.placements.size(), 6U);
  EXPECT_EQ(site.placements[4].serial, "T-0005");
  EXPECT_NEAR(site.placements[4].origin.x.value(), 0.6, 1e-12);
  EXPECT_NEAR(site.placements[4].origin.y.value(), 0.6, 1e-12);
  EXPECT_TRUE(SiteMap::build(site).value()->tags().empty()) << "nothing is registered yet";
}

TEST(NewFloor, givesEveryTagOfAPracticeFloorAUidOfItsOwn) {
  const auto map = SiteMap::build(layNewFloor(wish(true)).value());
  ASSERT_TRUE(map) << map.error().sentence;
  EXPECT_EQ((*map)->tags().size(), 6U * 8U);
}

TEST(NewFloor, putsAVehicleIntoTheMiddleOfAPracticeFloorAlone) {
  const auto site = layNewFloor(wish(true)).value();
  ASSERT_EQ(site.vehicles.size(), 1U);
  EXPECT_NEAR(site.vehicles[0].start->position.x.value(), 0.9, 1e-12);
  EXPECT_NEAR(site.vehicles[0].start->position.y.value(), 0.6, 1e-12);
  EXPECT_TRUE(layNewFloor(wish(false)).value().vehicles.empty());
}

TEST(NewFloor, isASiteThatItsFileGivesBack) {
  for (const TileType& type : usualTileTypes()) {
    const auto site = layNewFloor({"Hall", type, 2, 2, true}).value();
    const auto again = parseSite(writeSite(site), "new");
    ASSERT_TRUE(again) << again.error().sentence;
    EXPECT_EQ(*again, site) << type.name;
  }
}

TEST(NewFloor, hasATagInEachUsualTypeAndALatticeThatFitsIt) {
  for (const TileType& type : usualTileTypes()) {
    const auto tags = tagOffsets(type);
    ASSERT_FALSE(tags.empty()) << type.name;
    EXPECT_LE(tags.back().x, type.width) << type.name;
    EXPECT_NEAR(type.columns * type.pitch.value(), type.width.value(), 1e-9) << type.name;
  }
}

TEST(NewFloor, isEmptyWhereNoTilesAreAskedForAndKeepsTheirType) {
  const auto site = layNewFloor({"Hall", usualTileTypes()[2], 0, 0, true}).value();
  EXPECT_EQ(site.tileTypes, std::vector{usualTileTypes()[2]});
  EXPECT_TRUE(site.placements.empty() && site.tiles.empty() && site.zones.empty() && site.vehicles.empty());
}

TEST(NewFloor, refusesCountsOutOfRangeAndTypesWithoutTags) {
  auto none = wish(true);
  none.columns = 0;
  EXPECT_FALSE(layNewFloor(none));
  auto many = wish(true);
  many.rows = NewFloor::kMost + 1;
  EXPECT_FALSE(layNewFloor(many));
  auto bare = wish(true);
  bare.type.columns = 0;
  EXPECT_FALSE(layNewFloor(bare));
}

}  // namespace
}  // namespace tessera::floor
