// Areas against areas known by hand, and against counting points.
#include "region/region.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace tessera::region {
namespace {

Point at(double x, double y) { return {Metres{x}, Metres{y}}; }
Box box(double x0, double y0, double x1, double y1) { return {at(x0, y0), at(x1, y1)}; }
Region square(double x0, double y0, double x1, double y1) { return Region::of(box(x0, y0, x1, y1)); }

TEST(Region, hasTheAreaOfItsOutlineWhicheverWayItWasDrawn) {
  const std::vector<Point> ccw{at(0, 0), at(2, 0), at(2, 1), at(0, 1)};
  const std::vector<Point> cw{ccw.rbegin(), ccw.rend()};
  EXPECT_NEAR(Region::of(ccw).squareMetres(), 2.0, 1e-9);
  EXPECT_NEAR(Region::of(cw).squareMetres(), 2.0, 1e-9);
}

TEST(Region, isEmptyWithoutArea) {
  EXPECT_TRUE(Region::of(std::vector<Point>{}).empty());
  EXPECT_TRUE(Region::of(std::vector<Point>{at(0, 0), at(1, 1)}).empty());
  EXPECT_TRUE(Region::of(std::vector<Point>{at(0, 0), at(1, 1), at(2, 2), at(0, 0)}).empty());
  EXPECT_TRUE((square(0, 0, 1, 1) - square(0, 0, 1, 1)).empty());
  EXPECT_TRUE((square(0, 0, 1, 1) & square(1, 0, 2, 1)).empty()) << "they only touch";
}

TEST(Region, bearsPlacesThatAreNoNumbersOrFarAway) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(Region::of(std::vector<Point>{at(nan, 0), at(nan, nan), at(0, nan)}).empty());
  EXPECT_NEAR(Region::of(std::vector<Point>{at(-1e300, -1), at(1e300, -1), at(1e300, 1), at(-1e300, 1)}).squareMetres(),
              2e6 * 2, 1.0);
}

TEST(Region, takesAndJoinsAreas) {
  const Region a = square(0, 0, 2, 2);
  const Region b = square(1, 1, 3, 3);
  EXPECT_NEAR((a | b).squareMetres(), 7.0, 1e-9);
  EXPECT_NEAR((a & b).squareMetres(), 1.0, 1e-9);
  EXPECT_NEAR((a - b).squareMetres(), 3.0, 1e-9);
  EXPECT_EQ((a - b).bounds(), box(0, 0, 2, 2));
}

TEST(Region, aHoleIsNotInside) {
  const Region ring = square(0, 0, 4, 4) - square(1, 1, 3, 3);
  EXPECT_NEAR(ring.squareMetres(), 12.0, 1e-9);
  EXPECT_FALSE(ring.contains(at(2, 2)));
  EXPECT_TRUE(ring.contains(at(0.5, 2)));
  EXPECT_TRUE(ring.contains(at(1, 2))) << "the edge itself";
  EXPECT_FALSE(ring.contains(at(5, 2)));
}

TEST(Region, fallsIntoThePiecesThatDoNotTouch) {
  const Region island = (square(0, 0, 4, 4) - square(1, 1, 3, 3)) | square(1.5, 1.5, 2.5, 2.5) | square(10, -1, 11, 1);
  const auto pieces = island.pieces();
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_NEAR(pieces[0].squareMetres(), 2.0, 1e-9);
  EXPECT_NEAR(pieces[1].squareMetres(), 12.0, 1e-9);
  EXPECT_NEAR(pieces[2].squareMetres(), 1.0, 1e-9);
}

TEST(Region, growsAndShrinksWithSquareCorners) {
  EXPECT_NEAR(square(0, 0, 2, 1).grown(Metres{0.5}).squareMetres(), 6.0, 1e-6);
  EXPECT_NEAR(square(0, 0, 3, 2).grown(Metres{-0.5}).squareMetres(), 2.0, 1e-6);
  EXPECT_TRUE(square(0, 0, 3, 1).grown(Metres{-0.6}).empty());
}

TEST(Region, opensWhatIsNarrow) {
  const Region dumbbell = square(0, 0, 1, 1) | square(1, 0.45, 2, 0.55) | square(2, 0, 3, 1);
  const Region open = dumbbell.opened(Metres{0.2});
  EXPECT_EQ(open.pieces().size(), 2U);
  EXPECT_NEAR(open.squareMetres(), 2.0, 1e-6);
}

TEST(Region, coversWhatItIsCarriedOver) {
  EXPECT_NEAR(square(0, 0, 1, 1).swept({Metres{3}, {}}).squareMetres(), 4.0, 1e-9);
  EXPECT_NEAR(square(0, 0, 1, 1).swept({Metres{1}, Metres{1}}).squareMetres(), 1.0 + 2.0, 1e-9);
  EXPECT_EQ(square(0, 0, 1, 1).swept({}), square(0, 0, 1, 1));
}

TEST(Region, theUnionOfManyBoxesIsThatOfItsParts) {
  std::mt19937_64 random{5};
  std::uniform_int_distribution<int> place{0, 12};
  std::uniform_int_distribution<int> size{1, 3};
  for (int round = 0; round < 200; ++round) {
    std::vector<Box> boxes;
    for (int i = 0; i < 25; ++i) {
      const double x = place(random);
      const double y = place(random);
      boxes.push_back(box(x, y, x + size(random), y + size(random)));
    }
    int cells = 0;
    const Region all = Region::unionOf(boxes);
    for (int x = 0; x < 16; ++x) {
      for (int y = 0; y < 16; ++y) {
        const bool covered = std::any_of(boxes.begin(), boxes.end(), [&](const Box& b) {
          return b.low.x.value() <= x && x < b.high.x.value() && b.low.y.value() <= y && y < b.high.y.value();
        });
        cells += covered ? 1 : 0;
        ASSERT_EQ(all.contains(at(x + 0.5, y + 0.5)), covered);
      }
    }
    ASSERT_NEAR(all.squareMetres(), cells, 1e-6);
  }
}

TEST(Region, theUnionOfThousandsOfBoxesThatDoNotFitIsWhole) {
  std::mt19937_64 random{6};
  std::uniform_real_distribution<double> off{0.0, 0.2};
  std::vector<Box> boxes;
  for (int x = 0; x < 80; ++x) {
    for (int y = 0; y < 60; ++y) {
      if (x == 40 && y == 30) continue;
      boxes.push_back(box(x - off(random), y - off(random), x + 1 + off(random), y + 1 + off(random)));
    }
  }
  const Region all = Region::unionOf(boxes);
  EXPECT_EQ(all.pieces().size(), 1U);
  EXPECT_FALSE(all.contains(at(40.5, 30.5)));
  EXPECT_EQ(all.rings().size(), 2U) << "an outline and one hole";
}

TEST(Region, saysWhereAStraightWayLiesInside) {
  const Region ring = square(0, 0, 4, 4) - square(1, 1, 3, 3);
  const auto through = ring.within(at(-1, 2), at(5, 2));
  ASSERT_EQ(through.size(), 2U);
  EXPECT_NEAR(through[0].from, 1.0 / 6, 1e-9);
  EXPECT_NEAR(through[0].to, 2.0 / 6, 1e-9);
  EXPECT_NEAR(through[1].from, 4.0 / 6, 1e-9);
  EXPECT_TRUE(ring.within(at(5, 5), at(6, 6)).empty());
  const auto along = ring.within(at(-1, 0), at(5, 0));
  ASSERT_EQ(along.size(), 1U) << "the edge itself counts";
  EXPECT_NEAR(along[0].to, 5.0 / 6, 1e-9);
}

TEST(Region, aWayInsideAgreesWithItsPoints) {
  std::mt19937_64 random{9};
  std::uniform_real_distribution<double> coordinate{0, 10};
  for (int round = 0; round < 300; ++round) {
    std::vector<Point> outline;
    for (int i = 0; i < 9; ++i) outline.push_back(at(coordinate(random), coordinate(random)));
    const Region region = Region::of(outline);
    const Point a = at(coordinate(random), coordinate(random));
    const Point b = at(coordinate(random), coordinate(random));
    const auto stretches = region.within(a, b);
    for (int i = 0; i < 200; ++i) {
      const double share = (i + 0.5) / 200;
      bool inside = false;
      bool close = false;
      for (const Stretch& s : stretches) {
        inside = inside || (s.from <= share && share <= s.to);
        close = close || std::abs(s.from - share) < 1e-4 || std::abs(s.to - share) < 1e-4;
      }
      if (close) continue;
      ASSERT_EQ(region.contains(a + share * (b - a)), inside) << round << " at " << share;
    }
  }
}

}  // namespace
}  // namespace tessera::region
