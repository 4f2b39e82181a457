#include <gtest/gtest.h>

#include <random>
#include <set>

#include "canvas_site.h"
#include "ui/canvas/floor_index.h"
#include "ui/canvas/floor_mip.h"

namespace tessera::ui {
namespace {

TEST(FloorIndex, FindsJustTheTilesThatTouchARectangle) {
  std::mt19937 random{11};
  std::uniform_real_distribution<double> place{-40.0, 40.0};
  floor::Site site = tiledSite(0, 0);
  for (int n = 0; n < 400; ++n) {
    site.tiles.push_back({"R" + std::to_string(n), "60x60", {}});
    site.placements.push_back({"R" + std::to_string(n), {Metres{place(random)}, Metres{place(random)}}, n % 4});
  }
  const FloorIndex index{site};
  for (int n = 0; n < 200; ++n) {
    SiteBox box;
    box.add(Point{Metres{place(random)}, Metres{place(random)}});
    box.add(Point{Metres{place(random)}, Metres{place(random)}});
    std::set<std::string> found;
    index.forEachTile(box, [&](const FloorIndex::Tile& tile) { found.insert(index.serial(tile)); });
    std::set<std::string> expected;
    for (const FloorIndex::Tile& tile : index.tiles()) {
      if (tile.box.touches(box)) expected.insert(index.serial(tile));
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(FloorIndex, LaysTagsWhereTheMapHasThem) {
  floor::Site site = tiledSite(3, 3);
  for (std::size_t n = 0; n < site.placements.size(); ++n) site.placements[n].quarterTurns = static_cast<int>(n % 4);
  site.tiles[4].uids[2] = {};
  const auto map = floor::SiteMap::build(site).value();
  const FloorIndex index{site};
  std::size_t registered = 0;
  for (const FloorIndex::Tile& tile : index.tiles()) {
    const auto& offsets = index.offsetsOf(tile.shape);
    for (std::size_t n = 0; n < offsets.size(); ++n) {
      bool found = false;
      map->forEachNear(tile.origin + offsets[n], Metres{1e-6}, [&](const floor::PlacedTag&) { found = true; });
      EXPECT_EQ(index.isRegistered(tile.firstPlace + n), found);
      registered += found ? 1 : 0;
    }
  }
  EXPECT_EQ(registered, map->tags().size());
}

TEST(FloorIndex, BearsAFloorWithoutTiles) {
  const FloorIndex index{floor::Site{}};
  int found = 0;
  SiteBox box;
  box.add(Point{});
  index.forEachTile(box, [&](const FloorIndex::Tile&) { ++found; });
  EXPECT_EQ(found, 0);
  EXPECT_TRUE(index.box().empty());
}

TEST(SameFloor, HoldsForAnEditOfRoutesAndNotForAnotherTag) {
  const floor::Site site = tiledSite(2, 2);
  floor::Site edited = site;
  edited.routes.clear();
  edited.zones.push_back({"z", floor::ZoneKind::Parking, {{}, {Metres{1}, {}}, {{}, Metres{1}}}, {}, {}});
  EXPECT_TRUE(sameFloor(site, edited));
  edited.tiles[1].uids[0] = {};
  EXPECT_FALSE(sameFloor(site, edited));
}

TEST(FloorMip, CoversTheFloorAndShowsAHoleInIt) {
  floor::Site site = tiledSite(40, 40);
  std::erase_if(site.placements, [](const floor::Placement& p) {
    return p.origin.x > Metres{9.0} && p.origin.x < Metres{15.0} && p.origin.y > Metres{9.0} &&
           p.origin.y < Metres{15.0};
  });
  const FloorIndex index{site};
  const FloorMip mip{index};
  EXPECT_GT(mip.levels(), 3U);
  const FloorMip::Picture picture = mip.picture(index.box(), 4.0, CanvasTheme{QPalette{}});
  ASSERT_FALSE(picture.image.isNull());
  EXPECT_LT(picture.image.width(), 40 * 4);  // no more cells than pixels
  const auto alphaAt = [&](double x, double y) {
    const double across = (Metres{x} - picture.box.low.x) / picture.box.width();
    const double up = (Metres{y} - picture.box.low.y) / picture.box.height();
    return qAlpha(picture.image.pixel(static_cast<int>(across * picture.image.width()),
                                      static_cast<int>((1.0 - up) * picture.image.height())));
  };
  EXPECT_EQ(alphaAt(4.0, 4.0), 255);
  EXPECT_EQ(alphaAt(20.0, 12.0), 255);
  EXPECT_EQ(alphaAt(12.0, 12.0), 0);
}

TEST(FloorMip, ShowsNothingOutsideTheFloor) {
  const FloorIndex index{tiledSite(4, 4)};
  const FloorMip mip{index};
  SiteBox far;
  far.add(Point{Metres{500}, Metres{500}});
  far.add(Point{Metres{600}, Metres{600}});
  EXPECT_TRUE(mip.picture(far, 1.0, CanvasTheme{QPalette{}}).image.isNull());
  EXPECT_TRUE(FloorMip{FloorIndex{floor::Site{}}}.picture(far, 1.0, CanvasTheme{QPalette{}}).image.isNull());
}

}  // namespace
}  // namespace tessera::ui
