#include "ui/canvas/view.h"

#include <gtest/gtest.h>

#include <QLineF>
#include <cmath>
#include <random>

#include "ui/canvas/clip.h"

namespace tessera::ui {
namespace {

SiteBox boxOf(double left, double bottom, double right, double top) {
  SiteBox box;
  box.add(Point{Metres{left}, Metres{bottom}});
  box.add(Point{Metres{right}, Metres{top}});
  return box;
}

Point at(double x, double y) { return {Metres{x}, Metres{y}}; }

TEST(View, TurnsPixelsBackIntoTheSitePointsTheyCameFrom) {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> place{-500.0, 500.0};
  std::uniform_real_distribution<double> power{-1.0, 3.5};
  for (int n = 0; n < 1000; ++n) {
    View view{{1600, 900}, n % 2 == 0 ? 1.0 : 2.0};
    view.setScale(std::pow(10.0, power(random)));
    view.centreOn(at(place(random), place(random)));
    const Point p = at(place(random), place(random));
    EXPECT_LT(distance(view.toSite(view.toPixel(p)), p).value(), 1e-9 * 1e3);
  }
}

TEST(View, PointsYUpwards) {
  View view{{800, 600}, 1.0};
  EXPECT_LT(view.toPixel(at(0, 1)).y(), view.toPixel(at(0, 0)).y());
  EXPECT_GT(view.toPixel(at(1, 0)).x(), view.toPixel(at(0, 0)).x());
}

TEST(View, KeepsThePointUnderTheCursorWhenZooming) {
  View view{{1000, 700}, 1.0};
  const QPointF cursor{812, 133};
  const Point under = view.toSite(cursor);
  for (int n = 0; n < 20; ++n) view.zoomAbout(cursor, 1.2);
  // Half a device pixel for the place on the pixel lattice.
  EXPECT_LT(QLineF(view.toPixel(under), cursor).length(), 1.0);
  for (int n = 0; n < 20; ++n) view.zoomAbout(cursor, 1 / 1.2);
  EXPECT_LT(distance(view.toSite(cursor), under).value(), view.metres(1.5).value());
}

TEST(View, LiesOnWholeDevicePixels) {
  for (const double ratio : {1.0, 1.25, 1.5, 2.0}) {
    View view{{801, 601}, ratio};
    view.setScale(97.3);
    view.centreOn(at(1.2345, 6.789));
    const QPointF origin = view.toPixel(at(0, 0)) * ratio;
    EXPECT_NEAR(origin.x(), std::round(origin.x()), 1e-6);
    EXPECT_NEAR(origin.y(), std::round(origin.y()), 1e-6);
  }
}

TEST(View, FitsABoxIntoTheWindowWithItsMargin) {
  View view{{1000, 600}, 1.0};
  const SiteBox box = boxOf(-3, 2, 47, 12);
  view.fit(box, 50);
  EXPECT_NEAR(view.scale(), 900.0 / 50.0, 1e-9);
  EXPECT_NEAR(view.toPixel(box.low).x(), 50, 1);
  EXPECT_NEAR(view.toPixel(box.high).x(), 950, 1);
  EXPECT_GE(view.toPixel(box.high).y(), 50);
}

TEST(View, StaysWithinItsLimitsWhateverIsAsked) {
  View view{{1000, 600}, 1.0};
  view.zoomAbout({500, 300}, 1e30);
  EXPECT_LE(view.scale(), View::kMostScale);
  view.zoomAbout({500, 300}, 1e-30);
  EXPECT_GE(view.scale(), View::kLeastScale);
  const double before = view.scale();
  view.zoomAbout({500, 300}, 0.0);
  view.zoomAbout({500, 300}, -1.0);
  view.zoomAbout({500, 300}, std::nan(""));
  EXPECT_EQ(view.scale(), before);
  view.resize({0, 0}, 0.0);
  EXPECT_GT(view.size().width(), 0);
}

TEST(View, NeverLosesTheFloor) {
  View view{{1000, 600}, 1.0};
  view.setContent(boxOf(0, 0, 5, 5));
  view.fit(boxOf(0, 0, 5, 5), 40);
  for (int n = 0; n < 1000; ++n) view.panBy({-300, 200});
  EXPECT_TRUE(view.visible().touches(boxOf(0, 0, 5, 5)));
  for (int n = 0; n < 100; ++n) view.zoomAbout({0, 0}, 0.5);
  EXPECT_GE(view.pixels(Metres{5}), 0.2 * 600 - 1);
}

TEST(View, PansByWholePixels) {
  View view{{1000, 600}, 1.0};
  const QPointF before = view.toPixel(at(1, 1));
  view.panBy({13, -7});
  EXPECT_NEAR(view.toPixel(at(1, 1)).x() - before.x(), 13, 1e-6);
  EXPECT_NEAR(view.toPixel(at(1, 1)).y() - before.y(), -7, 1e-6);
}

TEST(Clip, CutsALineAtTheRectangle) {
  const QRectF window{0, 0, 100, 100};
  const auto cut = clipped(QLineF{-1e9, 50, 1e9, 50}, window);
  ASSERT_TRUE(cut);
  EXPECT_NEAR(cut->x1(), 0, 1e-3);
  EXPECT_NEAR(cut->x2(), 100, 1e-3);
  EXPECT_FALSE(clipped(QLineF{-10, -10, 200, -10}, window));
  EXPECT_FALSE(clipped(QLineF{-50, 20, 20, -50}, window));
}

TEST(Clip, CutsAPolygonAndKeepsOneThatSurroundsTheWindow) {
  const QRectF window{0, 0, 100, 100};
  EXPECT_EQ(clipped(QPolygonF{QRectF{-1e9, -1e9, 2e9, 2e9}}, window).boundingRect(), window);
  EXPECT_TRUE(clipped(QPolygonF{QRectF{200, 200, 10, 10}}, window).isEmpty());
  EXPECT_EQ(clipped(QPolygonF{QRectF{50, 50, 100, 20}}, window).boundingRect(), (QRectF{50, 50, 50, 20}));
}

TEST(Clip, LeavesTheStepsOfALineOutThatAreFarFromTheWindow) {
  const QRectF window{0, 0, 100, 100};
  const QPolygonF line{QPointF{-300, 50}, {-200, 50}, {-10, 50}, {50, 50}, {60, 300}, {60, 400}, {70, 90}};
  const auto runs = runsWithin(line, window);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0], (QPolygonF{QPointF{-10, 50}, {50, 50}, {60, 300}}));
  EXPECT_EQ(runs[1], (QPolygonF{QPointF{60, 400}, {70, 90}}));
  EXPECT_TRUE(runsWithin(line.translated(0, 1000), window).empty());
  EXPECT_EQ(runsWithin(QPolygonF{QRectF{10, 10, 20, 20}}, window).size(), 1U);
}

}  // namespace
}  // namespace tessera::ui
