// Changing a zone that stands, with mouse and keys.
#include <array>
#include <random>

#include "zone_board.h"

namespace tessera::ui {
namespace {

class ZoneToolEditing : public ZoneBoard {
protected:
  void SetUp() override {
    ZoneBoard::SetUp();
    click(1.2, 1.2);
    ASSERT_EQ(selection.zone(), "keep off") << "the smallest lies on top";
  }
};

TEST_F(ZoneToolEditing, ChoosesTheZoneBelowByAClickOnTheChosenOne) {
  click(1.2, 1.2);
  EXPECT_EQ(selection.zone(), "drive");
  click(1.2, 1.2);
  EXPECT_EQ(selection.zone(), "keep off");
  click(2.1, 1.8);
  EXPECT_EQ(selection.zone(), "drive");
  EXPECT_EQ(steps(), 0);
}

TEST_F(ZoneToolEditing, DragsACornerInOneStep) {
  drag(pixel(1.5, 0.9), pixel(1.8, 0.6));
  expectAt(zone(1).outline[1], 1.8, 0.6);
  EXPECT_EQ(steps(), 1);
  EXPECT_EQ(tool.corner(), 1U);
  document.undoStack().undo();
  expectAt(zone(1).outline[1], 1.5, 0.9);
}

TEST_F(ZoneToolEditing, InsertsACornerAtAnEdgesMiddleTheClosingOneIncluded) {
  drag(pixel(1.2, 0.9), pixel(1.2, 0.6));
  ASSERT_EQ(zone(1).outline.size(), 5U);
  expectAt(zone(1).outline[1], 1.2, 0.6);
  drag(pixel(0.9, 1.2), pixel(0.6, 1.2));
  ASSERT_EQ(zone(1).outline.size(), 6U);
  expectAt(zone(1).outline[5], 0.6, 1.2);
  EXPECT_EQ(steps(), 2);
}

TEST_F(ZoneToolEditing, DeletesTheChosenCornerButKeepsThree) {
  QSignalSpy refused{&tool, &ZoneTool::refused};
  click(1.5, 0.9);
  key(Qt::Key_Delete);
  EXPECT_EQ(zone(1).outline.size(), 3U);
  click(1.5, 1.5);
  ASSERT_TRUE(tool.corner());
  key(Qt::Key_Delete);
  EXPECT_EQ(zone(1).outline.size(), 3U);
  EXPECT_EQ(refused.count(), 1);
}

TEST_F(ZoneToolEditing, DeletesTheZoneWhileNoCornerIsChosen) {
  key(Qt::Key_Delete);
  ASSERT_EQ(zones(), 1U);
  EXPECT_EQ(zone(0).name, "drive");
  document.undoStack().undo();
  EXPECT_EQ(document.site(), zonedSite());
}

TEST_F(ZoneToolEditing, MovesTheWholeZoneAndSnapsItsNearestCorner) {
  drag(pixel(1.42, 1.42), pixel(1.42, 1.42) + (pixel(1.8, 1.8) - pixel(1.5, 1.5)) + QPoint{3, 2});
  EXPECT_EQ(zone(1).outline, (std::vector{placeAt(1.2, 1.2), placeAt(1.8, 1.2), placeAt(1.8, 1.8), placeAt(1.2, 1.8)}));
  EXPECT_EQ(steps(), 1);
  EXPECT_EQ(document.undoStack().undoText(), "Move keep off");
}

TEST_F(ZoneToolEditing, NudgesTheZoneOrTheCornerInOneStepEach) {
  key(Qt::Key_Right);
  key(Qt::Key_Right);
  key(Qt::Key_Up, Qt::ShiftModifier);
  expectAt(zone(1).outline[0], 0.92, 1.0);
  expectAt(zone(1).outline[2], 1.52, 1.6);
  EXPECT_EQ(steps(), 1);
  click(1.52, 1.6);
  ASSERT_EQ(tool.corner(), 2U);
  key(Qt::Key_Left);
  key(Qt::Key_Left);
  expectAt(zone(1).outline[2], 1.50, 1.6);
  EXPECT_EQ(steps(), 2);
}

TEST_F(ZoneToolEditing, EscapeInTheMiddleOfADragLeavesTheZoneWhereItWas) {
  QTest::mousePress(&canvas, Qt::LeftButton, {}, pixel(1.2, 1.2));
  moveTo(pixel(1.6, 1.6), {});
  key(Qt::Key_Escape);
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, pixel(1.6, 1.6));
  EXPECT_EQ(document.site(), zonedSite());
  EXPECT_EQ(canvas.tool(), &tool);
}

TEST_F(ZoneToolEditing, PansFromAZoneThatIsNotChosen) {
  const QPoint before = pixel(1.0, 1.0);
  drag(pixel(2.1, 1.95), pixel(2.1, 1.95) + QPoint{40, 20});
  EXPECT_EQ(pixel(1.0, 1.0) - before, (QPoint{40, 20}));
  EXPECT_EQ(selection.zone(), "drive");
  EXPECT_EQ(steps(), 0);
}

TEST_F(ZoneToolEditing, GivesADragUpWhenTheDocumentChangesUnderIt) {
  key(Qt::Key_Up);
  QTest::mousePress(&canvas, Qt::LeftButton, {}, pixel(1.2, 1.2));
  moveTo(pixel(1.6, 1.6), {});
  document.undoStack().undo();
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, pixel(1.6, 1.6));
  EXPECT_EQ(document.site(), zonedSite());
}

TEST_F(ZoneToolEditing, ChangesKindDuplicatesAndDeletesByTheMenu) {
  const auto choose = [&](const QString& label) {
    QTest::mouseClick(&canvas, Qt::RightButton, {}, pixel(1.2, 1.2));
    auto* menu = canvas.findChild<QMenu*>("zoneMenu");
    ASSERT_NE(menu, nullptr);
    QAction* found = nullptr;
    for (QAction* action : menu->findChildren<QAction*>())
      if (action->text().remove('&') == label) found = action;
    ASSERT_NE(found, nullptr) << label.toStdString();
    found->trigger();
    menu->close();
  };
  choose("Slow zone");
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_EQ(zone(1).kind, floor::ZoneKind::Slow);
  EXPECT_EQ(zone(1).speed, ZoneEdits::kUsualSpeed);
  choose("Duplicate zone");
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  ASSERT_EQ(zones(), 3U);
  EXPECT_EQ(selection.zone(), "keep off (copy)");
  choose("Delete zone");
  EXPECT_EQ(zones(), 2U);
}

// Whatever mouse and keys do, the steps lead back to where it began and forward to where it ended.
TEST_F(ZoneToolEditing, UndoesAndRedoesAnySequenceOfGestures) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random{seed};
    const auto below = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
    document.replace(floor::SiteMap::build(zonedSite()).value(), {});
    canvas.fit();
    static constexpr std::array kKeys{Qt::Key_Return, Qt::Key_Backspace, Qt::Key_Delete,
                                      Qt::Key_Left,   Qt::Key_Up,        Qt::Key_Right};
    for (int n = 0; n < 120; ++n) {
      canvas.setTool(&tool);
      const QPoint a{below(1000), below(800)};
      const QPoint b{below(1000), below(800)};
      const Qt::KeyboardModifiers modifiers{below(4) == 0 ? Qt::ShiftModifier : Qt::NoModifier};
      switch (below(8)) {
        case 0:
          tool.setKind(static_cast<floor::ZoneKind>(below(8)));
          tool.startDrawing();
          break;
        case 1:
          key(Qt::Key_Z, Qt::ControlModifier);
          break;
        case 2:
          key(kKeys.at(static_cast<std::size_t>(below(6))), modifiers);
          break;
        case 3:
          drag(a, b, modifiers);
          break;
        case 4:
          QTest::mouseDClick(&canvas, Qt::LeftButton, modifiers, a);
          break;
        case 5:
          if (zones() > 0) {
            const floor::Zone z = zone(static_cast<std::size_t>(below(static_cast<int>(zones()))));
            selection.setZone(QString::fromStdString(z.name));
            drag(canvas.view().toPixel(z.outline[0]).toPoint(), b, modifiers);
          }
          break;
        default:
          QTest::mouseClick(&canvas, Qt::LeftButton, modifiers, a);
          break;
      }
    }
    const floor::Site after = document.site();
    EXPECT_GT(steps(), 0) << "seed " << seed;
    while (document.undoStack().canUndo()) document.undoStack().undo();
    EXPECT_EQ(document.site(), zonedSite()) << "seed " << seed;
    while (document.undoStack().canRedo()) document.undoStack().redo();
    EXPECT_EQ(document.site(), after) << "seed " << seed;
    while (tool.cancel()) {
    }
  }
}

}  // namespace
}  // namespace tessera::ui
