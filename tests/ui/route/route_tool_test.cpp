// Drawing a new route with mouse and keys.
#include "drawing_board.h"

namespace tessera::ui {
namespace {

class RouteToolDrawing : public DrawingBoard {
protected:
  void SetUp() override {
    DrawingBoard::SetUp();
    tool.startDrawing();
  }
};

TEST_F(RouteToolDrawing, DrawsARouteByClicksAndFinishesByDoubleClick) {
  QSignalSpy finished{&tool, &RouteTool::finished};
  click(0.3, 1.5);
  click(1.2, 1.5);
  QTest::mouseDClick(&canvas, Qt::LeftButton, {}, pixel(1.2, 0.9));
  ASSERT_EQ(finished.count(), 1);
  EXPECT_EQ(finished[0][0].toString(), "Route 1");
  EXPECT_EQ(selection.route(), "Route 1");
  const auto drawn = vertices("Route 1");
  ASSERT_EQ(drawn.size(), 3U);
  expectAt(drawn[0], 0.3, 1.5);  // tiles' middles and corners
  expectAt(drawn[1], 1.2, 1.5, 0.02);
  expectAt(drawn[2], 1.2, 0.9, 0.02);
  EXPECT_FALSE(tool.isDrawing());
  EXPECT_EQ(document.undoStack().count(), 1);
}

TEST_F(RouteToolDrawing, FinishesByEnterAndNumbersTheNextOne) {
  click(0.3, 1.5);
  click(1.2, 1.5);
  key(Qt::Key_Return);
  tool.startDrawing();
  click(0.3, 2.1);
  click(1.2, 2.1);
  key(Qt::Key_Enter);
  EXPECT_EQ(routes(), 3U);
  EXPECT_NE(document.map()->route("Route 2"), nullptr);
}

TEST_F(RouteToolDrawing, UndoesToNothingAndRedoes) {
  const floor::Site before = document.site();
  click(0.3, 1.5);
  click(1.2, 1.5);
  key(Qt::Key_Return);
  const floor::Site after = document.site();
  document.undoStack().undo();
  EXPECT_EQ(document.site(), before);
  EXPECT_FALSE(document.undoStack().canUndo());
  document.undoStack().redo();
  EXPECT_EQ(document.site(), after);
}

TEST_F(RouteToolDrawing, TakesBackTheLastClickByBackspaceAndByUndo) {
  click(0.3, 1.5);
  click(1.2, 1.5);
  click(1.2, 0.9);
  key(Qt::Key_Backspace);
  EXPECT_EQ(tool.draft().size(), 2U);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(tool.draft().size(), 1U);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(tool.draft().size(), 2U);
  EXPECT_TRUE(canvas.undoInTool());
  EXPECT_TRUE(canvas.undoInTool());
  EXPECT_FALSE(canvas.undoInTool());  // the document's turn
  EXPECT_EQ(document.undoStack().count(), 0);
  EXPECT_TRUE(tool.isDrawing());
}

TEST_F(RouteToolDrawing, EscapeDropsTheUnfinishedRouteFirstAndTheToolThen) {
  click(0.3, 1.5);
  click(1.2, 1.5);
  key(Qt::Key_Escape);
  EXPECT_TRUE(tool.draft().empty());
  EXPECT_TRUE(tool.isDrawing());
  EXPECT_EQ(canvas.tool(), &tool);
  key(Qt::Key_Escape);
  EXPECT_FALSE(tool.isDrawing());
  EXPECT_EQ(canvas.tool(), nullptr);
  EXPECT_EQ(routes(), 1U);
}

TEST_F(RouteToolDrawing, RefusesARouteOfOneVertex) {
  QSignalSpy refused{&tool, &RouteTool::refused};
  click(0.3, 1.5);
  key(Qt::Key_Return);
  EXPECT_EQ(refused.count(), 1);
  EXPECT_EQ(routes(), 1U);
  EXPECT_EQ(tool.draft().size(), 1U);
  QTest::mouseDClick(&canvas, Qt::LeftButton, {}, pixel(0.3, 1.5));  // twice the same place is one vertex
  EXPECT_EQ(routes(), 1U);
}

TEST_F(RouteToolDrawing, HoldsDirectionsTo45DegreesWithShift) {
  click(0.3, 1.5);
  click(1.26, 1.62, Qt::ShiftModifier);
  click(1.80, 2.05, Qt::ShiftModifier);
  key(Qt::Key_Return);
  const auto drawn = vertices("Route 1");
  ASSERT_EQ(drawn.size(), 3U);
  EXPECT_EQ(drawn[1].y, drawn[0].y);
  const Offset leg = drawn[2] - drawn[1];
  EXPECT_NEAR(leg.x.value(), leg.y.value(), 0.0011);
}

TEST_F(RouteToolDrawing, SnapsToTagsAndNotWithAlt) {
  const double tagX = 0.6 + 0.075 + 0.15;
  const double tagY = 1.8 + 0.075 + 0.15;
  click(tagX + 0.012, tagY - 0.012);
  expectAt(tool.draft().back(), tagX, tagY);
  key(Qt::Key_Backspace);
  click(tagX + 0.03, tagY - 0.02, Qt::AltModifier);
  expectAt(tool.draft().back(), tagX + 0.03, tagY - 0.02, canvas.view().metres(1.0).value());
  EXPECT_NE(tool.draft().back(), at(tagX, tagY));
}

TEST_F(RouteToolDrawing, PansByMiddleButtonAndZoomsInTheMiddleOfDrawing) {
  click(0.3, 1.5);
  QTest::mousePress(&canvas, Qt::MiddleButton, {}, {500, 400});
  QTest::mouseMove(&canvas, {480, 380});
  QTest::mouseRelease(&canvas, Qt::MiddleButton, {}, {480, 380});
  key(Qt::Key_Plus);
  EXPECT_EQ(tool.draft().size(), 1U);
  click(1.2, 1.5);
  key(Qt::Key_Return);
  EXPECT_EQ(vertices("Route 1").size(), 2U);
}

TEST_F(RouteToolDrawing, ForgetsTheUnfinishedRouteWhenAnotherSiteIsOpened) {
  click(0.3, 1.5);
  document.replace(tiledMap(2, 2), {});
  EXPECT_TRUE(tool.draft().empty());
  EXPECT_FALSE(tool.isDrawing());
}

TEST_F(RouteToolDrawing, OffersItsStepsByRightClick) {
  click(0.3, 1.5);
  click(1.2, 1.5);
  QTest::mouseClick(&canvas, Qt::RightButton, {}, pixel(1.5, 1.0));
  auto* menu = canvas.findChild<QMenu*>("routeMenu");
  ASSERT_NE(menu, nullptr);
  ASSERT_FALSE(menu->actions().isEmpty());
  menu->actions().front()->trigger();
  menu->close();
  EXPECT_EQ(vertices("Route 1").size(), 2U);
}

TEST_F(RouteToolDrawing, SaysWhatToDoNext) {
  QSignalSpy hints{&canvas, &FloorCanvas::hintChanged};
  const QString first = tool.hint();
  click(0.3, 1.5);
  EXPECT_FALSE(hints.isEmpty());
  EXPECT_NE(tool.hint(), first);
  key(Qt::Key_Escape);
  key(Qt::Key_Escape);
  EXPECT_EQ(hints.last()[0].toString(), "");
}

}  // namespace
}  // namespace tessera::ui
