// The measuring tool under a real mouse and real keys.
#include "ui/measure/measure_tool.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "canvas_site.h"
#include "ui/canvas/floor_canvas.h"

namespace tessera::ui {
namespace {

class Measuring : public testing::Test {
protected:
  void SetUp() override {
    canvas.resize(900, 600);
    canvas.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
    canvas.openMap(tiledMap(5, 4));
    canvas.setTool(&tool);
    canvas.setFocus();
  }
  [[nodiscard]] QPoint pixel(double x, double y) const {
    return canvas.view().toPixel({Metres{x}, Metres{y}}).toPoint();
  }
  void click(double x, double y, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mouseMove(&canvas, pixel(x, y));
    QTest::mouseClick(&canvas, button, {}, pixel(x, y));
  }

  FloorCanvas canvas;
  MeasureTool tool;
};

TEST_F(Measuring, addsUpTheStretchesAndTellsTheAreaBetweenTileCorners) {
  click(0.6, 0.6);
  click(1.8, 0.6);
  click(1.8, 1.2);
  QTest::keyClick(&canvas, Qt::Key_Return);
  EXPECT_TRUE(tool.isComplete());
  ASSERT_EQ(tool.points().size(), 3U);
  EXPECT_NEAR(tool.length().value(), 1.8, 1e-9) << "it snaps to the corners of tiles";
  EXPECT_NEAR(tool.area(), 0.36, 1e-9);
}

TEST_F(Measuring, hasItsReadoutAboveTheSignsOfFaults) {
  click(0.6, 0.6);
  click(1.8, 0.6);
  QTest::keyClick(&canvas, Qt::Key_Return);
  const QImage before = canvas.grab().toImage();
  // Where the readout stands, which is to the right of the last point and above it or below.
  std::vector<FloorMark> marks;
  for (const QPoint beside : {QPoint{40, 30}, QPoint{40, -30}}) {
    const Point place = canvas.view().toSite(pixel(1.8, 0.6) + beside);
    SiteBox box;
    box.add(place);
    FloorMark mark;
    mark.place = box;
    mark.severe = true;
    marks.push_back(mark);
  }
  canvas.setMarks(marks, std::nullopt);
  const QImage after = canvas.grab().toImage();
  const auto differing = [&](QPoint middle) {
    int count = 0;
    for (int y = -6; y <= 6; ++y)
      for (int x = -6; x <= 6; ++x) {
        const QPoint at = (middle + QPoint{x, y}) * before.devicePixelRatio();
        count += QColor{before.pixel(at)}.lightness() - QColor{after.pixel(at)}.lightness() > 60 ? 1 : 0;
      }
    return count;
  };
  const int below = differing(pixel(1.8, 0.6) + QPoint{40, 30});
  const int above = differing(pixel(1.8, 0.6) + QPoint{40, -30});
  EXPECT_EQ(std::min(below, above), 0) << "one of them lies beneath the readout: " << below << " " << above;
  EXPECT_GT(std::max(below, above), 20) << "the other is seen";
}

TEST_F(Measuring, measuresADragFromEndToEnd) {
  QTest::mousePress(&canvas, Qt::LeftButton, {}, pixel(0.6, 0.6));
  QTest::mouseMove(&canvas, pixel(1.0, 1.0));
  QTest::mouseMove(&canvas, pixel(1.2, 1.2));
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, pixel(1.2, 1.2));
  EXPECT_TRUE(tool.isComplete());
  EXPECT_NEAR(tool.length().value(), std::hypot(0.6, 0.6), 1e-9);
}

TEST_F(Measuring, beginsAnewWithTheNextClick) {
  click(0.6, 0.6);
  click(1.2, 0.6);
  click(1.2, 0.6, Qt::RightButton);
  EXPECT_TRUE(tool.isComplete());
  click(1.8, 1.8);
  EXPECT_EQ(tool.points().size(), 1U);
  EXPECT_FALSE(tool.isComplete());
}

TEST_F(Measuring, takesBackClickByClickAndThenLeavesUndoToTheDocument) {
  click(0.6, 0.6);
  click(1.2, 0.6);
  QTest::keyClick(&canvas, Qt::Key_Backspace);
  EXPECT_EQ(tool.points().size(), 1U);
  EXPECT_TRUE(canvas.undoInTool());
  EXPECT_TRUE(tool.points().empty());
  EXPECT_FALSE(canvas.undoInTool());
}

TEST_F(Measuring, endsByEscapeFirstTheWayThenTheTool) {
  click(0.6, 0.6);
  QTest::keyClick(&canvas, Qt::Key_Escape);
  EXPECT_TRUE(tool.points().empty());
  EXPECT_EQ(canvas.tool(), &tool);
  QTest::keyClick(&canvas, Qt::Key_Escape);
  EXPECT_EQ(canvas.tool(), nullptr);
}

TEST_F(Measuring, showsWhatItMeasures) {
  canvas.finishDrawing();
  const QImage before = canvas.grab().toImage();
  click(0.6, 0.6);
  click(2.4, 0.6);
  QTest::keyClick(&canvas, Qt::Key_Return);
  EXPECT_NE(canvas.grab().toImage(), before);
  EXPECT_NE(canvas.grab().toImage().pixelColor(pixel(1.05, 0.6)), before.pixelColor(pixel(1.05, 0.6)));
}

}  // namespace
}  // namespace tessera::ui
