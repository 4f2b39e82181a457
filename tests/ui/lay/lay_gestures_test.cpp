// Where tiles snap to, and what a gesture collects, without any mouse.
#include "ui/lay/lay_gestures.h"

#include <gtest/gtest.h>

#include <chrono>

#include "floor/laid_tile.h"
#include "floor/new_floor.h"

namespace tessera::ui {
namespace {

Point at(double x, double y) { return {Metres{x}, Metres{y}}; }
Offset size(double x, double y) { return {Metres{x}, Metres{y}}; }
void expectNear(Point p, double x, double y) {
  EXPECT_NEAR(p.x.value(), x, 1e-6);
  EXPECT_NEAR(p.y.value(), y, 1e-6);
}

TEST(TileSnap, goesOnWithTheLatticeOfATileOfTheSameSize) {
  const Box neighbour{at(1.0, 2.0), at(1.6, 2.6)};
  expectNear(besideTile(at(1.65, 2.05), size(0.6, 0.6), neighbour), 1.6, 2.0);
  expectNear(besideTile(at(0.3, 3.3), size(0.6, 0.6), neighbour), 0.4, 3.2);
  expectNear(besideTile(at(1.1, 1.5), size(0.6, 0.6), neighbour), 1.0, 1.4);
}

TEST(TileSnap, laysAnotherSizeFlushOrTouching) {
  const Box neighbour{at(0.0, 0.0), at(0.6, 0.6)};
  expectNear(besideTile(at(0.57, 0.04), size(0.3, 0.3), neighbour), 0.6, 0.0);
  expectNear(besideTile(at(0.57, 0.28), size(0.3, 0.3), neighbour), 0.6, 0.3);
  expectNear(besideTile(at(-0.33, 0.02), size(0.3, 0.3), neighbour), -0.3, 0.0);
  expectNear(besideTile(at(1.22, 0.0), size(0.3, 0.3), neighbour), 1.2, 0.0);
}

TEST(TileSnap, knowsFreeFloor) {
  const FloorIndex floor{floor::layNewFloor({"", floor::usualTileTypes()[0], 2, 2, false}).value()};
  EXPECT_FALSE(isFree(floor, boxOf(at(0.5, 0.5), size(0.6, 0.6))));
  EXPECT_TRUE(isFree(floor, boxOf(at(1.2, 0.0), size(0.6, 0.6))));
  EXPECT_TRUE(isFree(floor, boxOf(at(1.1995, 0.0), size(0.6, 0.6)))) << "half a millimetre is touching";
  EXPECT_FALSE(isFree(floor, boxOf(at(1.19, 0.0), size(0.6, 0.6))));
}

TEST(LayGesture, strokeLeavesNoCellOutAndTakesNoneTwice) {
  const FloorIndex empty{floor::Site{}};
  LayStroke stroke{{at(0.0, 0.0), size(0.6, 0.6)}};
  stroke.goTo({0, 0}, empty);
  stroke.goTo({5, 0}, empty);
  stroke.goTo({0, 0}, empty);
  EXPECT_EQ(stroke.boxes().size(), 6U);
  stroke.goTo({0, -3}, empty);
  EXPECT_EQ(stroke.boxes().size(), 9U);
}

TEST(LayGesture, stampTurnsFourTimesToWhatItWas) {
  floor::Site site = floor::layNewFloor({"", floor::usualTileTypes()[0], 3, 2, true}).value();
  site.tileTypes[0].width = Metres{0.5};  // gaps between, and no square
  site.placements[1].quarterTurns = 1;
  site.placements[1].origin = site.placements[1].origin + size(0.6, 0.0);
  const TileStamp stamp = stampOf(site, {"T-0001", "T-0002", "T-0005"});
  ASSERT_EQ(stamp.tiles.size(), 3U);
  TileStamp turned = stamp;
  for (int n = 0; n < 4; ++n) {
    turned.turn();
    for (const NewTile& tile : turned.tiles) {
      const Box box = turned.boxOf(tile, {});
      EXPECT_GE(box.low.x.value(), -1e-6);
      EXPECT_GE(box.low.y.value(), -1e-6);
      EXPECT_LE(box.high.x.value(), turned.size.x.value() + 1e-6);
      EXPECT_LE(box.high.y.value(), turned.size.y.value() + 1e-6);
    }
  }
  for (std::size_t n = 0; n < 3; ++n) {
    expectNear(turned.tiles[n].low, stamp.tiles[n].low.x.value(), stamp.tiles[n].low.y.value());
    EXPECT_EQ(turned.tiles[n].quarterTurns, stamp.tiles[n].quarterTurns);
  }
}

// The preview of a stroke must not grow with the floor: looked up by place, never copied.
TEST(LayGesture, looksAtFewTilesOfALargeFloor) {
  const FloorIndex floor{floor::layNewFloor({"", floor::usualTileTypes()[0], 200, 140, false}).value()};
  ASSERT_EQ(floor.tiles().size(), 28'000U);
  std::size_t looked = 0;
  const SkipTile counting = [&](const FloorIndex::Tile&) {
    ++looked;
    return false;
  };
  expectNear(snappedTile(floor, size(0.6, 0.6), at(119.97, 30.02), counting), 120.0, 30.0);
  EXPECT_TRUE(isFree(floor, boxOf(at(120.0, 30.0), size(0.6, 0.6)), kTouching, counting));
  EXPECT_LE(looked, 30U);
}

}  // namespace
}  // namespace tessera::ui
