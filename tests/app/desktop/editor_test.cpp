// Changing a site in the whole window: zones, what is wrong with them, and how it is mended, by mouse and keys.
#include <QAbstractItemView>
#include <QDockWidget>
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
