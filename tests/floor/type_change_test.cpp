#include "floor/type_change.h"

#include <gtest/gtest.h>

#include "floor/laid_tile.h"
#include "floor/new_floor.h"
#include "floor/site_json.h"
#include "floor/site_map.h"

namespace tessera::floor {
namespace {

class TypeChanged : public testing::Test {
protected:
  Site site = layNewFloor({"Hall", usualTileTypes()[0], 3, 2, true}).value();
  TileType type = site.tileTypes[0];
  [[nodiscard]] Point placeOfUid(const TagUid& uid) const { return *SiteMap::build(site).value()->find(uid); }
};

TEST_F(TypeChanged, keepsEveryUidAtItsPlaceWhereTheTagsAreMore) {
  const TagUid uid = site.tiles[4].uids[5];
  const Point before = placeOfUid(uid);
  type.pattern = Pattern::Full;
  const TypeChange told = foresee(site, type.name, type);
  EXPECT_EQ(told.tiles, 6U);
  EXPECT_EQ(told.kept, 48U);
  EXPECT_EQ(told.dropped, 0U);
  changeTileType(site, type.name, type);
  EXPECT_EQ(placeOfUid(uid), before);
  EXPECT_EQ(site.tileTypes[0], type);
}

TEST_F(TypeChanged, dropsTheUidsOfPlacesThatAreNoTagsAnyMore) {
  type.pattern = Pattern::Custom;
  type.custom.assign(16, false);
  type.custom[0] = type.custom[1] = true;  // the first was a tag, the second was none
  const TypeChange told = foresee(site, type.name, type);
  const TypeChange done = changeTileType(site, type.name, type);
  EXPECT_EQ(told.kept, 6U);
  EXPECT_EQ(told.dropped, 42U);
  EXPECT_EQ(done.kept, told.kept);
  EXPECT_EQ(done.dropped, told.dropped);
  EXPECT_EQ(useOf(site, type.name).registered, 6U);
  EXPECT_TRUE(SiteMap::build(site));
}

TEST_F(TypeChanged, renamesTheTypeOfItsTilesAndNothingElse) {
  const Site before = site;
  type.name = "other";
  changeTileType(site, before.tileTypes[0].name, type);
  EXPECT_EQ(useOf(site, "other").tiles, 6U);
  EXPECT_EQ(useOf(site, before.tileTypes[0].name).tiles, 0U);
  type.name = before.tileTypes[0].name;
  changeTileType(site, "other", type);
  EXPECT_EQ(site, before);
}

TEST_F(TypeChanged, keepsTheCornerOfTilesThatAreTurned) {
  for (int turns = 0; turns < 4; ++turns) site.placements[static_cast<std::size_t>(turns)].quarterTurns = turns;
  const Site before = site;
  type.width = Metres{0.7};
  type.height = Metres{0.8};
  changeTileType(site, type.name, type);
  for (std::size_t n = 0; n < 4; ++n) {
    const Point was = boxOf(before.placements[n], before.tileTypes[0]).low;
    const Point is = boxOf(site.placements[n], type).low;
    EXPECT_NEAR(was.x.value(), is.x.value(), 1e-9) << n;
    EXPECT_NEAR(was.y.value(), is.y.value(), 1e-9) << n;
  }
}

TEST_F(TypeChanged, changesNothingWhereTheTypeIsNotKnown) {
  const Site before = site;
  EXPECT_EQ(changeTileType(site, "nobody", type).tiles, 0U);
  EXPECT_EQ(foresee(site, "nobody", type).tiles, 0U);
  EXPECT_EQ(site, before);
}

TEST(TileTypeCheck, takesWhatAFileTakesAndRefusesWhatItRefuses) {
  Site site = layNewFloor({"Hall", usualTileTypes()[0], 1, 1, false}).value();
  const TileType good = site.tileTypes[0];
  const auto agrees = [&](const TileType& type) {
    site.tileTypes[0] = type;
    site.tiles[0].type = type.name;
    const bool file = parseSite(writeSite(site), "test").has_value();
    EXPECT_EQ(checkTileType(type).has_value(), file);
    return file;
  };
  EXPECT_TRUE(agrees(good));
  const auto changed = [&](auto what) {
    TileType type = good;
    what(type);
    return agrees(type);
  };
  EXPECT_FALSE(changed([](TileType& t) { t.name.clear(); }));
  EXPECT_FALSE(changed([](TileType& t) { t.columns = 5; }));
  EXPECT_FALSE(changed([](TileType& t) { t.margin.y = Metres{0.16}; }));
  EXPECT_FALSE(changed([](TileType& t) { t.width = Metres{0.5}; }));
  EXPECT_FALSE(changed([](TileType& t) { t.margin.x = Metres{-0.01}; }));
  EXPECT_TRUE(changed([](TileType& t) { t.margin = {}; }));
}

TEST(TileTypeCheck, fitsAsManyPlacesAsThePitchLetsOnTheTile) {
  TileType type = usualTileTypes()[0];
  type.width = Metres{0.5};
  type = withPlacesFitted(type);
  EXPECT_EQ(type.columns, 3);
  EXPECT_EQ(type.rows, 4);
  EXPECT_NEAR(type.margin.x.value(), 0.1, 1e-9);
  EXPECT_NEAR(type.margin.y.value(), 0.075, 1e-9);
  EXPECT_TRUE(checkTileType(type));
  type.pitch = Metres{2.0};
  type = withPlacesFitted(type);
  EXPECT_EQ(type.columns, 1);
  EXPECT_TRUE(checkTileType(type));
}

}  // namespace
}  // namespace tessera::floor
