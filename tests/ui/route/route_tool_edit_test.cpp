// Changing a route that stands, with mouse and keys.
#include <random>

#include "drawing_board.h"

namespace tessera::ui {
namespace {

class RouteToolEditing : public DrawingBoard {
protected:
  void SetUp() override {
    DrawingBoard::SetUp();
    click(1.2, 0.5);  // a leg of "one"
    ASSERT_EQ(selection.route(), "one");
  }
};

TEST_F(RouteToolEditing, DragsAVertexInOneStep) {
  drag(pixel(2.0, 0.5), pixel(2.4, 0.6));
  expectAt(vertices("one")[1], 2.4, 0.6, 0.02);
  EXPECT_EQ(document.undoStack().count(), 1);
  EXPECT_EQ(tool.vertex(), 1U);
  document.undoStack().undo();
  expectAt(vertices("one")[1], 2.0, 0.5);
}

TEST_F(RouteToolEditing, LeavesARouteAloneThatWasOnlyClicked) {
  click(2.0, 0.5);
  EXPECT_EQ(tool.vertex(), 1U);
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(RouteToolEditing, InsertsAVertexAtALegsMiddle) {
  drag(pixel(1.25, 0.5), pixel(1.2, 0.9));
  ASSERT_EQ(vertices("one").size(), 4U);
  expectAt(vertices("one")[1], 1.2, 0.9, 0.02);
  EXPECT_EQ(document.undoStack().count(), 1);
  EXPECT_EQ(tool.vertex(), 1U);
}

TEST_F(RouteToolEditing, InsertsByAClickWithoutMoving) {
  click(2.0, 1.25);
  ASSERT_EQ(vertices("one").size(), 4U);
  expectAt(vertices("one")[2], 2.0, 1.25);
}

TEST_F(RouteToolEditing, DeletesTheChosenVertexButKeepsTwo) {
  QSignalSpy refused{&tool, &RouteTool::refused};
  click(2.0, 0.5);
  key(Qt::Key_Delete);
  EXPECT_EQ(vertices("one").size(), 2U);
  click(2.0, 2.0);
  key(Qt::Key_Delete);
  EXPECT_EQ(vertices("one").size(), 2U);
  EXPECT_EQ(refused.count(), 1);
}

TEST_F(RouteToolEditing, NudgesByArrowKeysInOneStep) {
  click(2.0, 2.0);
  key(Qt::Key_Right);
  key(Qt::Key_Right);
  key(Qt::Key_Up, Qt::ShiftModifier);
  expectAt(vertices("one")[2], 2.02, 2.10);
  EXPECT_EQ(document.undoStack().count(), 1);
  click(0.5, 0.5);  // another vertex begins another step
  key(Qt::Key_Left);
  EXPECT_EQ(document.undoStack().count(), 2);
  document.undoStack().undo();
  document.undoStack().undo();
  expectAt(vertices("one")[2], 2.0, 2.0);
}

TEST_F(RouteToolEditing, EscapeInTheMiddleOfADragLeavesTheVertexWhereItWas) {
  QTest::mousePress(&canvas, Qt::LeftButton, {}, pixel(2.0, 0.5));
  moveTo(pixel(2.4, 0.9), {});
  key(Qt::Key_Escape);
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, pixel(2.4, 0.9));
  expectAt(vertices("one")[1], 2.0, 0.5);
  EXPECT_EQ(document.undoStack().count(), 0);
  EXPECT_EQ(canvas.tool(), &tool);
}

TEST_F(RouteToolEditing, HoldsADragTo45DegreesWithShift) {
  drag(pixel(2.0, 0.5), pixel(2.42, 0.58), Qt::ShiftModifier);
  EXPECT_EQ(vertices("one")[1].y, Metres{0.5});
  EXPECT_NEAR(vertices("one")[1].x.value(), 2.42, 0.02);
}

TEST_F(RouteToolEditing, GivesADragUpWhenTheDocumentChangesUnderIt) {
  click(2.0, 2.0);
  key(Qt::Key_Up);
  QTest::mousePress(&canvas, Qt::LeftButton, {}, pixel(2.0, 0.5));
  moveTo(pixel(2.4, 0.9), {});
  document.undoStack().undo();
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, pixel(2.4, 0.9));
  expectAt(vertices("one")[1], 2.0, 0.5);
}

TEST_F(RouteToolEditing, PansFromEmptyFloor) {
  const QPoint before = pixel(1.0, 1.0);
  drag(pixel(1.0, 1.6), pixel(1.0, 1.6) + QPoint{50, 20});
  EXPECT_EQ(pixel(1.0, 1.0) - before, (QPoint{50, 20}));
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(RouteToolEditing, ReversesAndDeletesByTheMenu) {
  const auto choose = [&](int index) {
    QTest::mouseClick(&canvas, Qt::RightButton, {}, pixel(1.6, 0.5));
    auto* menu = canvas.findChild<QMenu*>("routeMenu");
    ASSERT_NE(menu, nullptr);
    menu->actions().at(index)->trigger();
    menu->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  choose(1);
  expectAt(vertices("one").front(), 2.0, 2.0);
  choose(0);  // insert here
  EXPECT_EQ(vertices("one").size(), 4U);
  choose(4);  // on the vertex that was inserted: delete it, split there, reverse, duplicate, delete
  EXPECT_EQ(routes(), 0U);
}

// Whatever mouse and keys do, the steps lead back to where it began and forward to where it ended.
TEST_F(RouteToolEditing, UndoesAndRedoesAnySequenceOfGestures) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random{seed};
    const auto below = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
    document.replace(tiledMap(5, 4), {});
    canvas.fit();
    const floor::Site before = document.site();
    static constexpr std::array kKeys{Qt::Key_Return, Qt::Key_Backspace, Qt::Key_Delete,
                                      Qt::Key_Left,   Qt::Key_Up,        Qt::Key_Right};
    for (int n = 0; n < 120; ++n) {
      canvas.setTool(&tool);
      const QPoint a{below(1000), below(800)};
      const QPoint b{below(1000), below(800)};
      const Qt::KeyboardModifiers modifiers{below(4) == 0 ? Qt::ShiftModifier : Qt::NoModifier};
      switch (below(9)) {
        case 0:
          tool.startDrawing();
          break;
        case 1:
          key(Qt::Key_Z, Qt::ControlModifier);
          break;
        case 2:
          key(kKeys[static_cast<std::size_t>(below(6))], modifiers);
          break;
        case 3:
          drag(a, b, modifiers);
          break;
        case 4:
          QTest::mouseDClick(&canvas, Qt::LeftButton, modifiers, a);
          break;
        case 5:
          if (!document.site().routes.empty()) {
            const auto& route = document.site().routes[static_cast<std::size_t>(below(static_cast<int>(routes())))];
            selection.setRoute(QString::fromStdString(route.name));
            drag(canvas.view().toPixel(route.vertices[0]).toPoint(), b, modifiers);
          }
          break;
        case 6:
          if (below(4) == 0) key(Qt::Key_Escape);
          break;
        default:
          QTest::mouseClick(&canvas, Qt::LeftButton, modifiers, a);
          break;
      }
    }
    const floor::Site after = document.site();
    EXPECT_GT(document.undoStack().count(), 0) << "seed " << seed;
    while (document.undoStack().canUndo()) document.undoStack().undo();
    EXPECT_EQ(document.site(), before) << "seed " << seed;
    while (document.undoStack().canRedo()) document.undoStack().redo();
    EXPECT_EQ(document.site(), after) << "seed " << seed;
    tool.cancel();
  }
}

}  // namespace
}  // namespace tessera::ui
