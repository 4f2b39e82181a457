// Marks on the floor: seen, switched off, told under the mouse, and gone to.
#include <gtest/gtest.h>

#include <QApplication>
#include <QHelpEvent>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>

#include "canvas_site.h"
#include "ui/canvas/floor_canvas.h"

namespace tessera::ui {
namespace {

SiteBox boxAt(double x, double y, double width, double height) {
  return {{Metres{x}, Metres{y}}, {Metres{x + width}, Metres{y + height}}};
}

class MarksUnderTest : public testing::Test {
protected:
  void SetUp() override {
    canvas.resize(800, 600);
    canvas.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
    canvas.openMap(tiledMap(20, 15));
  }
  [[nodiscard]] QImage picture() {
    canvas.finishDrawing();
    return canvas.grab().toImage();
  }
  [[nodiscard]] QPoint pixel(const SiteBox& box) const { return canvas.view().toPixel(box.centre()).toPoint(); }
  FloorCanvas canvas;
};

TEST_F(MarksUnderTest, AreSeenUntilTheirLayerIsSwitchedOff) {
  const QImage without = picture();
  const SiteBox place = boxAt(3.0, 3.0, 0.6, 0.6);
  canvas.setMarks({{place, true, "hole"}}, {});
  const QImage with = picture();
  EXPECT_NE(with, without);
  EXPECT_NE(with.pixelColor(pixel(place) + QPoint{-5, 0}), without.pixelColor(pixel(place) + QPoint{-5, 0}));
  CanvasLayers layers = canvas.layers();
  layers.faults = false;
  canvas.setLayers(layers);
  EXPECT_EQ(picture(), without);
}

TEST_F(MarksUnderTest, GoToTheMiddleOfTheWindowNearEnoughToBeSeen) {
  const SiteBox place = boxAt(10.2, 7.3, 0.0, 0.0);
  canvas.showPlace(place);
  EXPECT_LE((pixel(place) - canvas.rect().center()).manhattanLength(), 2);
  EXPECT_GE(canvas.view().scale(), 60.0);
  const SiteBox large = boxAt(0.0, 0.0, 12.0, 9.0);
  canvas.showPlace(large);
  EXPECT_TRUE(QRectF(canvas.rect()).contains(canvas.view().toPixel(large.low)));
  EXPECT_TRUE(QRectF(canvas.rect()).contains(canvas.view().toPixel(large.high)));
}

TEST_F(MarksUnderTest, AreToldUnderTheMouseErrorsFirst) {
  const SiteBox place = boxAt(3.0, 3.0, 0.0, 0.0);
  const std::vector<FloorMark> marks{{place, false, "odd"}, {place, true, "wrong"}};
  ASSERT_NE(markAt(marks, canvas.view(), pixel(place)), nullptr);
  EXPECT_EQ(markAt(marks, canvas.view(), pixel(place))->sentence, "wrong");
  EXPECT_EQ(markAt(marks, canvas.view(), pixel(place) + QPoint{30, 0}), nullptr);
}

class FinickyTool : public CanvasTool {
public:
  bool mousePressed(const ToolMouse&, const CanvasScene&) override {
    ++presses;
    return true;
  }
  bool mouseMoved(const ToolMouse&, const CanvasScene&) override { return false; }
  bool mouseReleased(const ToolMouse&, const CanvasScene&) override { return false; }
  bool mouseDoubleClicked(const ToolMouse&, const CanvasScene&) override { return false; }
  bool keyPressed(QKeyEvent&, const CanvasScene&) override { return false; }
  bool keyReleased(QKeyEvent&, const CanvasScene&) override { return false; }
  [[nodiscard]] bool wantsShortcut(const QKeyEvent&) const override { return false; }
  void paint(QPainter&, const CanvasScene&, const CanvasTheme&) override {}
  [[nodiscard]] std::span<const FloorMark> marks() const override { return own; }
  [[nodiscard]] bool hasHandleAt(QPointF pixel, const CanvasScene&) const override {
    return handle && (*handle - pixel).manhattanLength() <= 10.0;
  }
  [[nodiscard]] bool isBusy() const override { return busy; }
  [[nodiscard]] QCursor cursor() const override { return Qt::ArrowCursor; }
  [[nodiscard]] QString hint() const override { return {}; }
  bool cancel() override { return false; }
  int presses = 0;
  bool busy = false;
  std::vector<FloorMark> own;
  std::optional<QPointF> handle;
};

TEST_F(MarksUnderTest, StandBesideAHandleWhichStaysInReach) {
  FinickyTool tool;
  canvas.setTool(&tool);
  const FloorMark mark{boxAt(6.0, 4.5, 0.0, 0.0), true, "too tight", 3};
  const QImage without = picture();
  canvas.setMarks({mark}, {});
  const QPoint at = pixel(mark.place);
  EXPECT_EQ(canvas.signOf(mark).toPoint(), at);
  tool.handle = canvas.view().toPixel(mark.place.centre());
  const QPoint sign = canvas.signOf(mark).toPoint();
  EXPECT_GT((sign - at).manhattanLength(), 20);
  Q_EMIT tool.changed();
  const QImage with = picture();
  EXPECT_NE(with.pixelColor(sign + QPoint{-5, 0}), without.pixelColor(sign + QPoint{-5, 0}));
  EXPECT_EQ(with.pixelColor(at), without.pixelColor(at)) << "what is grabbed is to be seen";
  QSignalSpy asked{&canvas, &FloorCanvas::markMenuRequested};
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, at);
  QTest::mouseClick(&canvas, Qt::RightButton, {}, at);
  EXPECT_EQ(tool.presses, 2);
  EXPECT_EQ(asked.count(), 0);
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, sign);
  QTest::mouseClick(&canvas, Qt::RightButton, {}, sign);
  EXPECT_EQ(tool.presses, 2);
  ASSERT_EQ(asked.count(), 2);
  EXPECT_EQ(asked[0][0].toInt(), 3);
  // At the window's edges as well.
  for (const QPoint corner : {QPoint{1, 1}, QPoint{799, 1}, QPoint{1, 599}, QPoint{799, 599}}) {
    const Point place = canvas.view().toSite(corner);
    const FloorMark far{{place, place}, true, "far"};
    tool.handle = canvas.view().toPixel(place);
    EXPECT_TRUE(canvas.rect().contains(canvas.signOf(far).toPoint())) << corner.x() << ", " << corner.y();
  }
  canvas.setTool(nullptr);
}

TEST_F(MarksUnderTest, HaveAMenuUnlessAToolIsInTheMiddleOfSomething) {
  FinickyTool tool;
  canvas.setTool(&tool);
  const SiteBox place = boxAt(3.0, 3.0, 0.6, 0.6);
  canvas.setMarks({{boxAt(6.0, 6.0, 0.0, 0.0), true, "no menu"}, {place, false, "odd", 7}}, {});
  QSignalSpy asked{&canvas, &FloorCanvas::markMenuRequested};
  QTest::mouseClick(&canvas, Qt::RightButton, {}, pixel(place));
  ASSERT_EQ(asked.count(), 1);
  EXPECT_EQ(asked[0][0].toInt(), 7);
  EXPECT_EQ(tool.presses, 0);
  canvas.openToolMenu();
  EXPECT_EQ(tool.presses, 1) << "it can be had all the same";
  QTest::mouseClick(&canvas, Qt::RightButton, {}, pixel(place) + QPoint{40, 0});
  QTest::mouseClick(&canvas, Qt::RightButton, {}, pixel(boxAt(6.0, 6.0, 0.0, 0.0)));
  tool.busy = true;
  QTest::mouseClick(&canvas, Qt::RightButton, {}, pixel(place));
  EXPECT_EQ(asked.count(), 1);
  EXPECT_EQ(tool.presses, 4);
  canvas.setTool(nullptr);
}

TEST_F(MarksUnderTest, OfAToolSayTheirSentenceUnderTheMouse) {
  FinickyTool tool;
  tool.own = {{boxAt(3.0, 3.0, 0.0, 0.0), true, "too close to the wall"}};
  canvas.setTool(&tool);
  const QPoint at = pixel(tool.own[0].place);
  QHelpEvent help{QEvent::ToolTip, at, canvas.mapToGlobal(at)};
  QApplication::sendEvent(&canvas, &help);
  EXPECT_EQ(QToolTip::text(), "too close to the wall");
  QToolTip::hideText();
  canvas.setTool(nullptr);
}

// As many as a check tells of one kind: what covers one another is drawn once.
TEST_F(MarksUnderTest, BearThousandsAndPlacesBeyondReason) {
  std::vector<FloorMark> marks;
  for (int n = 0; n < 20'000; ++n)
    marks.push_back({boxAt(0.001 * (n % 500), 0.001 * (n / 500), 0.1, 0.1), n % 2 == 0, {}});
  marks.push_back({boxAt(-1e5, -1e5, 2e5, 2e5), true, {}});
  canvas.setMarks(marks, marks.size() - 1);
  EXPECT_FALSE(picture().isNull());
  canvas.showPlace(marks.back().place);
  EXPECT_FALSE(picture().isNull());
  canvas.setMarks(marks, marks.size() + 7);
  EXPECT_FALSE(picture().isNull());
}

}  // namespace
}  // namespace tessera::ui
