// Changing a site in the whole window: zones, what is wrong with them, and how it is mended, by mouse and keys.
#include <QAbstractItemView>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QToolButton>

#include "app/desktop/desktop_fixture.h"
#include "app/tessera/site_files.h"
#include "ui/canvas/floor_canvas.h"

namespace tessera::desktop {
namespace {

class Editor : public DesktopTest {
protected:
  void SetUp() override {
    openWindow(false);
    ASSERT_TRUE(window->files().openDemo());
  }
  void dragFloor(double x0, double y0, double x1, double y1) {
    const QPoint from = pixelOf(x0, y0);
    const QPoint to = pixelOf(x1, y1);
    QTest::mousePress(&window->canvas(), Qt::LeftButton, {}, from);
    for (int n = 1; n <= 5; ++n) {
      const QPoint at = from + (to - from) * n / 5;
      QMouseEvent move{QEvent::MouseMove, at, window->canvas().mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                       Qt::NoModifier};
      QApplication::sendEvent(&window->canvas(), &move);
    }
    QTest::mouseRelease(&window->canvas(), Qt::LeftButton, {}, to);
  }
  /// A no-go zone across the first leg of the demo's first route.
  void barTheRoute() {
    const auto& way = window->document().site().routes.front().vertices;
    const Point middle = way[0] + 0.5 * (way[1] - way[0]);
    const double x = middle.x.value();
    const double y = middle.y.value();
    press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_NO_FATAL_FAILURE(dragFloor(x - 0.2, y - 0.2, x + 0.2, y + 0.2));
    ASSERT_EQ(window->document().site().zones.back().kind, floor::ZoneKind::NoGo);
  }
  [[nodiscard]] QString summary() { return find<QToolButton>("faultSummary")->text(); }
};

TEST_F(Editor, drawsAZoneWhichIsCheckedListedAndUndone) {
  const floor::Site before = window->document().site();
  EXPECT_TRUE(until([&] { return !summary().contains("error") && !summary().contains("Checking"); }))
      << summary().toStdString();
  ASSERT_NO_FATAL_FAILURE(barTheRoute());
  EXPECT_TRUE(find("zonePanel")->isVisible()) << "the tool brings its panel";
  EXPECT_TRUE(until([&] { return summary().contains("error"); })) << summary().toStdString();
  EXPECT_TRUE(window->canvas().marked().empty()) << "who does not ask for faults is not shown them";
  QTest::mouseClick(find("faultSummary"), Qt::LeftButton);
  auto* list = find<QAbstractItemView>("faultList");
  ASSERT_TRUE(until([&] { return list->isVisible() && list->model()->rowCount() > 0; }));
  EXPECT_FALSE(window->canvas().marked().empty());
  EXPECT_TRUE(list->model()->index(0, 0).data().toString().contains("no-go zone"));
  const double scale = window->canvas().view().scale();
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(0, 0)).center());
  EXPECT_GE(window->canvas().view().scale(), std::min(scale, 60.0));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window->document().site(), before);
  EXPECT_TRUE(until([&] { return !summary().contains("error"); })) << summary().toStdString();
}

TEST_F(Editor, saysWhatIsWrongWithARouteWhileItIsDrawn) {
  ASSERT_NO_FATAL_FAILURE(barTheRoute());
  const auto way = window->document().site().routes.front().vertices;
  trigger("drawRoute");
  clickFloor(way[0].x.value(), way[0].y.value());
  window->canvas().finishDrawing();
  QTest::mouseMove(&window->canvas(), pixelOf(way[1].x.value(), way[1].y.value()));
  const QImage atOnce = window->canvas().grab().toImage();
  EXPECT_TRUE(until([&] { return window->canvas().grab().toImage() != atOnce; })) << "the fault comes a moment later";
}

TEST_F(Editor, marksWhatIsWrongWithTheChosenRouteAndMendsItByTheMarksMenu) {
  const auto route = [this]() -> const floor::Route& { return window->document().site().routes.front(); };
  const Point inside = route().vertices[0];
  ASSERT_TRUE(window->document().edit("Move", [](floor::Site& site) {
    auto& vertex = site.routes.front().vertices[0];
    vertex = {Metres{-0.1}, vertex.y};
  }));
  ASSERT_NE(route().vertices[0], inside);
  ASSERT_TRUE(until([&] { return summary().contains("error"); })) << summary().toStdString();
  EXPECT_TRUE(window->canvas().marked().empty());
  trigger("editRoutes");
  window->canvas().fit();
  const Point first = route().vertices[1] + 0.3 * (route().vertices[2] - route().vertices[1]);
  clickFloor(first.x.value(), first.y.value());
  ASSERT_TRUE(until([&] { return !window->canvas().marked().empty(); })) << "with the tool, without the panel";
  EXPECT_TRUE(find<QDockWidget>("faultsDock")->isHidden());
  const ui::FloorMark mark = window->canvas().marked().front();
  EXPECT_TRUE(mark.sentence.contains(QString::fromStdString(route().name))) << mark.sentence.toStdString();
  const QPoint at = window->canvas().signOf(mark).toPoint();
  const auto menuAt = [&](QPoint pixel) {
    QTest::mouseClick(&window->canvas(), Qt::RightButton, {}, pixel);
    return window->findChild<QMenu*>("faultMenu");
  };
  QMenu* menu = menuAt(at);
  ASSERT_NE(menu, nullptr);
  ASSERT_EQ(menu->actions().size(), 4);
  EXPECT_TRUE(menu->actions()[0]->text().startsWith("Move vertex 1")) << menu->actions()[0]->text().toStdString();
  QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(menu->actions()[2]).center());
  ASSERT_TRUE(until([&] { return find<QAbstractItemView>("faultList")->isVisible(); }));
  EXPECT_EQ(find<QAbstractItemView>("faultList")->currentIndex().data().toString(), mark.sentence);
  find<QDockWidget>("faultsDock")->close();
  ASSERT_TRUE(until([&] { return window->findChild<QMenu*>("faultMenu") == nullptr; }));
  menu = menuAt(at);
  ASSERT_NE(menu, nullptr);
  QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(menu->actions()[0]).center());
  EXPECT_GT(route().vertices[0].x, Metres{0.0});
  EXPECT_TRUE(until([&] { return !summary().contains("error"); })) << summary().toStdString();
  trigger("undo");
  EXPECT_EQ(route().vertices[0].x, Metres{-0.1});
  EXPECT_TRUE(until([&] { return !window->canvas().marked().empty(); }));
  trigger("browse");
  EXPECT_TRUE(window->canvas().marked().empty()) << "they go with the tool";
}

TEST_F(Editor, showsAMarkBesideTheVertexThatItIsOf) {
  const auto vertex = [this] { return window->document().site().routes.front().vertices[1]; };
  const Point before = vertex();
  const double x = before.x.value();
  const double y = before.y.value();
  press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_NO_FATAL_FAILURE(dragFloor(x - 0.12, y - 0.12, x + 0.12, y + 0.12));
  trigger("editRoutes");
  auto& canvas = window->canvas();
  const Point first = before + 0.3 * (window->document().site().routes.front().vertices[2] - before);
  clickFloor(first.x.value(), first.y.value());
  ASSERT_TRUE(until([&] { return !canvas.marked().empty(); }));
  const ui::FloorMark mark = canvas.marked().front();
  const auto middle = [&] { return canvas.view().toPixel(mark.place.centre()); };
  for (int n = 0; n < 8 && canvas.signOf(mark) == middle(); ++n) canvas.zoomOut();
  const QPoint sign = canvas.signOf(mark).toPoint();
  ASSERT_GT((sign - middle().toPoint()).manhattanLength(), 20);
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, sign);
  QMenu* menu = window->findChild<QMenu*>("faultMenu");
  ASSERT_NE(menu, nullptr);
  EXPECT_TRUE(menu->isVisible());
  menu->close();
  ASSERT_TRUE(until([&] { return window->findChild<QMenu*>("faultMenu") == nullptr; }));
  EXPECT_EQ(vertex(), before);
  dragFloor(x, y, x + 0.6, y + 0.3);
  EXPECT_GT(distance(vertex(), before), Metres{0.3}) << "the handle lies free";
}

TEST_F(Editor, keepsTheRoomAroundVehiclesForThePerson) {
  trigger("showFaults");
  auto* room = find<QDoubleSpinBox>("clearance");
  room->setFocus();
  room->selectAll();
  QTest::keyClicks(room, "0.35");
  QTest::keyClick(room, Qt::Key_Return);
  ASSERT_TRUE(closeWindow());
  openWindow(false);
  EXPECT_EQ(find<QDoubleSpinBox>("clearance")->value(), 0.35);
}

TEST_F(Editor, takesTurnsWithTheOtherTools) {
  trigger("editZones");
  EXPECT_TRUE(find<QAction>("editZones")->isChecked());
  EXPECT_FALSE(find<QAction>("browse")->isChecked());
  trigger("drawRoute");
  EXPECT_FALSE(find<QAction>("editZones")->isChecked());
  EXPECT_TRUE(find<QAction>("drawRoute")->isChecked());
  trigger("drawZone");
  EXPECT_TRUE(find<QAction>("drawZone")->isChecked());
  EXPECT_FALSE(find<QAction>("drawRoute")->isChecked());
  QTest::keyClick(&window->canvas(), Qt::Key_Escape);
  EXPECT_TRUE(find<QAction>("browse")->isChecked());
}

}  // namespace
}  // namespace tessera::desktop
