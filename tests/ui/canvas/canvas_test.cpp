// The canvas under a real mouse and real keys.
#include <gtest/gtest.h>

#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

#include "canvas_site.h"
#include "ui/canvas/floor_canvas.h"

namespace tessera::ui {
namespace {

class CanvasUnderTest : public testing::Test {
protected:
  void SetUp() override {
    canvas.resize(900, 600);
    canvas.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
    canvas.openMap(tiledMap(5, 4));
  }
  [[nodiscard]] QPoint pixel(double x, double y) const {
    return canvas.view().toPixel({Metres{x}, Metres{y}}).toPoint();
  }
  void wheel(QPoint at, int turn) {
    QWheelEvent event{at,   canvas.mapToGlobal(at), {}, {0, turn}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false};
    QApplication::sendEvent(&canvas, &event);
  }
  void drag(Qt::MouseButton button, QPoint from, QPoint to) {
    QTest::mousePress(&canvas, button, {}, from);
    QTest::mouseMove(&canvas, from + (to - from) / 2);
    QTest::mouseMove(&canvas, to);
    QTest::mouseRelease(&canvas, button, {}, to);
  }

  [[nodiscard]] QImage picture() {
    canvas.finishDrawing();
    return canvas.grab().toImage();
  }

  FloorCanvas canvas;
};

TEST_F(CanvasUnderTest, ShowsTheWholeFloorAtFirstAndStillAfterAResize) {
  const SiteBox floor = FloorIndex{tiledSite(5, 4)}.box();
  for (const QSize size : {QSize{900, 600}, QSize{500, 700}}) {
    canvas.resize(size);
    EXPECT_TRUE(QRectF(canvas.rect()).contains(canvas.view().toPixel(floor.low)));
    EXPECT_TRUE(QRectF(canvas.rect()).contains(canvas.view().toPixel(floor.high)));
  }
}

TEST_F(CanvasUnderTest, ZoomsAboutTheCursorByTheWheel) {
  const QPoint cursor = pixel(1.0, 1.0);
  const double before = canvas.view().scale();
  QSignalSpy scaled{&canvas, &FloorCanvas::scaleChanged};
  wheel(cursor, 120);
  EXPECT_GT(canvas.view().scale(), before * 1.1);
  EXPECT_LT((pixel(1.0, 1.0) - cursor).manhattanLength(), 3);
  wheel(cursor, -120);
  EXPECT_NEAR(canvas.view().scale(), before, 1e-6);
  EXPECT_EQ(scaled.count(), 2);
}

TEST_F(CanvasUnderTest, PansByMiddleButtonBySpaceAndByIdleLeftButton) {
  canvas.zoomIn();
  canvas.zoomIn();
  const auto moves = [&](auto gesture) {
    const QPoint before = pixel(1.0, 1.0);
    gesture();
    return pixel(1.0, 1.0) - before;
  };
  EXPECT_EQ(moves([&] { drag(Qt::MiddleButton, {400, 300}, {440, 270}); }), (QPoint{40, -30}));
  EXPECT_EQ(moves([&] { drag(Qt::LeftButton, {400, 300}, {380, 330}); }), (QPoint{-20, 30}));
  QTest::keyPress(&canvas, Qt::Key_Space);
  EXPECT_EQ(moves([&] { drag(Qt::LeftButton, {400, 300}, {410, 330}); }), (QPoint{10, 30}));
  QTest::keyRelease(&canvas, Qt::Key_Space);
}

TEST_F(CanvasUnderTest, PansZoomsAndFitsByKeys) {
  const double fitted = canvas.view().scale();
  QTest::keyClick(&canvas, Qt::Key_Plus);
  EXPECT_GT(canvas.view().scale(), fitted);
  QTest::keyClick(&canvas, Qt::Key_Minus);
  EXPECT_NEAR(canvas.view().scale(), fitted, 1e-9);
  const int before = pixel(1.0, 1.0).x();
  QTest::keyClick(&canvas, Qt::Key_Right);
  EXPECT_LT(pixel(1.0, 1.0).x(), before);
  QTest::keyClick(&canvas, Qt::Key_0);
  EXPECT_EQ(pixel(1.0, 1.0).x(), before);
}

TEST_F(CanvasUnderTest, TellsTheSitePlaceUnderTheCursor) {
  QSignalSpy pointed{&canvas, &FloorCanvas::pointed};
  QTest::mouseMove(&canvas, pixel(1.5, 0.9));
  ASSERT_FALSE(pointed.isEmpty());
  const auto place = pointed.last().at(0).value<std::optional<Point>>();
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x.value(), 1.5, 0.01);
  EXPECT_NEAR(place->y.value(), 0.9, 0.01);
  QEvent leave{QEvent::Leave};
  QApplication::sendEvent(&canvas, &leave);
  EXPECT_FALSE(pointed.last().at(0).value<std::optional<Point>>());
}

TEST_F(CanvasUnderTest, PicksVehiclesBeforeRoutesBeforeTheFloor) {
  canvas.setSnapshot(snapshotOf(1.0, {vehicleAt(2, 1.0, 0.5)}));
  QSignalSpy vehicles{&canvas, &FloorCanvas::vehiclePicked};
  QSignalSpy routes{&canvas, &FloorCanvas::routePicked};
  QSignalSpy floors{&canvas, &FloorCanvas::floorPicked};
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, pixel(1.0, 0.5));
  ASSERT_EQ(vehicles.count(), 1);
  EXPECT_EQ(vehicles[0][0].value<VehicleId>(), VehicleId{2});
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, pixel(1.0, 1.4) + QPoint{0, 3});
  ASSERT_EQ(routes.count(), 1);
  EXPECT_EQ(routes[0][0].toString(), "two");
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, pixel(2.6, 2.2));
  EXPECT_EQ(floors.count(), 1);
  EXPECT_EQ(vehicles.count() + routes.count(), 2);
}

TEST_F(CanvasUnderTest, FollowsAVehicleByDoubleClickUntilSomebodyPans) {
  auto v = vehicleAt(1, 0.5, 0.5);
  canvas.setSnapshot(snapshotOf(1.0, {v}));
  for (int n = 0; n < 4; ++n) canvas.zoomIn();
  canvas.centreOn({Metres{0.5}, Metres{0.5}});
  QTest::mouseDClick(&canvas, Qt::LeftButton, {}, pixel(0.5, 0.5));
  EXPECT_EQ(canvas.followed(), VehicleId{1});
  v.pose.position.x = Metres{2.5};
  canvas.setSnapshot(snapshotOf(1.1, {v}));
  EXPECT_TRUE(canvas.rect().adjusted(200, 140, -200, -140).contains(pixel(2.5, 0.5)));
  drag(Qt::MiddleButton, {400, 300}, {430, 300});
  EXPECT_FALSE(canvas.followed());
}

TEST_F(CanvasUnderTest, ShowsHowVehiclesRoundTheCornersOfTheChosenRoute) {
  const auto colourInside = [&](double cut, const QString& chosen) {
    floor::Site site = tiledSite(5, 4);
    for (floor::VehicleSetup& vehicle : site.vehicles) vehicle.cornerCut = Metres{cut};
    canvas.openMap(floor::SiteMap::build(site).value());
    canvas.setSelectedRoute(chosen);
    // Where an arc that leaves the corner at (2.0, 0.5) by 15 cm is nearest to it.
    return picture().pixelColor(pixel(2.0 - 0.15 * std::sqrt(0.5), 0.5 + 0.15 * std::sqrt(0.5)));
  };
  const QColor floor = colourInside(0.0, "one");
  EXPECT_NE(colourInside(0.15, "one"), floor);
  EXPECT_EQ(colourInside(0.15, "two"), floor);
  EXPECT_EQ(colourInside(0.05, "one"), floor) << "that arc lies nearer to the corner";
}

TEST_F(CanvasUnderTest, KeepsTheViewWhateverIsEditedAndFitsAnotherSite) {
  for (const bool moved : {false, true}) {
    if (moved) {
      canvas.zoomIn();
      canvas.centreOn({Metres{0.7}, Metres{0.8}});
    }
    const View before = canvas.view();
    floor::Site site = tiledSite(5, 4);
    site.routes.pop_back();
    canvas.setMap(floor::SiteMap::build(site).value());
    EXPECT_TRUE(canvas.view() == before);
    canvas.setMap(tiledMap(40, 40));
    EXPECT_TRUE(canvas.view() == before);
  }
  const double near = canvas.view().scale();
  canvas.openMap(tiledMap(40, 40));
  EXPECT_LT(canvas.view().scale(), near);
  EXPECT_TRUE(QRectF(canvas.rect()).contains(canvas.view().toPixel({Metres{24}, Metres{24}})));
}

TEST_F(CanvasUnderTest, ShowsTilesThatAreLaidAndNoLongerThoseThatWereTakenUp) {
  floor::Site site = tiledSite(5, 4);
  const QPoint last = pixel(2.97, 2.37);  // between tags of the last tile
  const QColor tile = picture().pixelColor(last);
  const floor::Placement placement = site.placements.back();
  site.placements.pop_back();
  canvas.setMap(floor::SiteMap::build(site).value());
  EXPECT_NE(picture().pixelColor(last), tile);
  site.placements.push_back(placement);
  canvas.setMap(floor::SiteMap::build(site).value());
  EXPECT_EQ(picture().pixelColor(last), tile);
}

TEST_F(CanvasUnderTest, DrawsFramesOnlyWhileSomethingMoves) {
  canvas.setSnapshot(snapshotOf(1.0, {vehicleAt(1, 1, 1)}));
  EXPECT_FALSE(canvas.isAnimating());
  auto v = vehicleAt(1, 1, 1);
  v.speed = MetresPerSecond{0.3};
  canvas.setSnapshot(snapshotOf(1.1, {v}));
  EXPECT_TRUE(canvas.isAnimating());
  EXPECT_TRUE(QTest::qWaitFor([&] { return !canvas.isAnimating(); }));
  canvas.setSnapshot(snapshotOf(1.2, {v}));
  canvas.hide();
  EXPECT_FALSE(canvas.isAnimating());
}

TEST_F(CanvasUnderTest, ShowsAVehicleInItsPlaceAndTakesItAwayAgain) {
  const QColor floor = picture().pixelColor(pixel(1.35, 1.05));
  auto v = vehicleAt(1, 1.3, 1.05);
  v.covariance = {};
  canvas.setSnapshot(snapshotOf(1.0, {v}));
  EXPECT_NE(picture().pixelColor(pixel(1.35, 1.05)), floor);
  canvas.setSnapshot(nullptr);
  EXPECT_EQ(picture().pixelColor(pixel(1.35, 1.05)), floor);
}

TEST_F(CanvasUnderTest, LeavesOutWhatIsSwitchedOff) {
  const QPoint onRoute = pixel(0.9, 1.4);
  const QColor route = picture().pixelColor(onRoute);
  CanvasLayers layers;
  layers.routes = false;
  layers.tags = false;
  canvas.setLayers(layers);
  EXPECT_NE(picture().pixelColor(onRoute), route);
  QSignalSpy routes{&canvas, &FloorCanvas::routePicked};
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, onRoute);
  EXPECT_EQ(routes.count(), 0);
}

TEST_F(CanvasUnderTest, ShowsTheOldPictureScaledUntilTheNewOneIsComplete) {
  canvas.openMap(tiledMap(60, 40));
  canvas.finishDrawing();
  canvas.zoomIn();
  const QImage atOnce = canvas.grab().toImage();  // however little of the new one is ready
  EXPECT_NE(atOnce.pixelColor(450, 300), atOnce.pixelColor(895, 5)) << "the floor is there, the surroundings too";
  EXPECT_TRUE(QTest::qWaitFor([&] { return canvas.isDrawn(); }));
  EXPECT_EQ(canvas.grab().toImage(), picture());
}

TEST_F(CanvasUnderTest, TrailsGrowFadeAndGoWithTheirRun) {
  const auto at = [&](double time, double x) {
    auto v = vehicleAt(1, x, 0.62);
    v.covariance = {};
    canvas.setSnapshot(snapshotOf(time, {v}));
  };
  const QColor floor = picture().pixelColor(pixel(1.0, 0.62));
  for (int n = 0; n <= 20; ++n) at(0.1 * n, 0.7 + 0.05 * n);
  const QColor young = canvas.grab().toImage().pixelColor(pixel(1.0, 0.62));
  EXPECT_NE(young, floor);
  at(45.0, 1.71);
  canvas.finishDrawing();
  at(46.5, 1.71);
  CanvasLayers without;
  without.trails = false;
  canvas.setLayers(without);
  EXPECT_EQ(picture().pixelColor(pixel(1.0, 0.62)), floor);
  canvas.setLayers({});
  const QColor old = picture().pixelColor(pixel(1.0, 0.62));
  EXPECT_NE(old, floor);
  EXPECT_NE(old, young) << "it fades";
  canvas.setSnapshot(nullptr);
  EXPECT_EQ(picture().pixelColor(pixel(1.0, 0.62)), floor);
}

TEST_F(CanvasUnderTest, TurnsDarkWithThePalette) {
  const auto corner = [&] { return picture().pixelColor(890, 300).lightness(); };
  EXPECT_GT(corner(), 128);
  QPalette dark;
  dark.setColor(QPalette::Window, QColor{30, 30, 30});
  dark.setColor(QPalette::Text, Qt::white);
  canvas.setPalette(dark);
  EXPECT_LT(corner(), 128);
}

TEST_F(CanvasUnderTest, BearsStrangeSitesAndSnapshots) {
  floor::Site site = tiledSite(2, 2);
  site.routes.push_back({"far", {{Metres{-1e5}, Metres{-1e5}}, {Metres{1e5}, Metres{1e5}}}, Metres{0.01}});
  site.routes.push_back({"point", {{}, {}}, Metres{0.2}});
  site.zones.push_back(
      {"huge", floor::ZoneKind::NoGo, {{Metres{-1e5}, {}}, {Metres{1e5}, {}}, {{}, Metres{1e5}}}, {}, {}});
  canvas.openMap(floor::SiteMap::build(site).value());
  canvas.setSelectedRoute("far");
  auto v = vehicleAt(9, 1e5, -1e5);  // not in the site
  const double nan = std::nan("");
  v.covariance = {nan, nan, nan, nan, nan, nan, nan, nan, nan};
  v.obstacle = Metres{1e4};
  auto w = vehicleAt(1, nan, nan);
  canvas.setSnapshot(snapshotOf(1.0, {v, w}));
  for (int n = 0; n < 40; ++n) {
    canvas.zoomIn();
    canvas.finishDrawing();
  }
  for (int n = 0; n < 80; ++n) canvas.zoomOut();
  EXPECT_FALSE(picture().isNull());
  canvas.setSnapshot(nullptr);
  canvas.openMap(nullptr);
  EXPECT_FALSE(picture().isNull());
}

}  // namespace
}  // namespace tessera::ui
