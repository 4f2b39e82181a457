// Choosing laid tiles and changing them: moved, turned, aligned, copied, deleted.
#include <algorithm>

#include "laying_board.h"

namespace tessera::ui {
namespace {

class Choosing : public LayingBoard {
protected:
  void SetUp() override {
    LayingBoard::SetUp();
    ASSERT_NO_FATAL_FAILURE(fill(3, 2));
    key(Qt::Key_C);
  }
  static TileSet set(std::initializer_list<const char*> serials) { return {serials.begin(), serials.end()}; }
};

TEST_F(Choosing, ChoosesByClickAndMoreWithControl) {
  click(0.3, 0.3);
  EXPECT_EQ(tool.chosen(), set({"T-0001"}));
  click(0.9, 0.3, Qt::ControlModifier);
  EXPECT_EQ(tool.chosen(), set({"T-0001", "T-0002"}));
  click(0.3, 0.3, Qt::ControlModifier);
  EXPECT_EQ(tool.chosen(), set({"T-0002"}));
  click(1.5, 0.9);
  EXPECT_EQ(tool.chosen(), set({"T-0006"}));
  click(3.5, 3.0);
  EXPECT_TRUE(tool.chosen().empty());
}

TEST_F(Choosing, ChoosesWhatARectangleTouches) {
  drag(2.2, 0.8, 1.0, 0.1);
  EXPECT_EQ(tool.chosen(), set({"T-0002", "T-0003", "T-0005", "T-0006"}));
  drag(2.2, 0.2, 1.9, 0.1, Qt::ControlModifier);
  EXPECT_EQ(tool.chosen().size(), 4U);
  key(Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(tool.chosen().size(), 6U);
  EXPECT_EQ(steps(), 1) << "choosing is no step";
}

TEST_F(Choosing, MovesByDragOntoTheLattice) {
  drag(1.5, 0.9, 1.48, 2.13);
  expectAt("T-0006", 1.2, 1.8);
  EXPECT_EQ(steps(), 2);
  EXPECT_EQ(tool.chosen(), set({"T-0006"}));
}

TEST_F(Choosing, MovesAllChosenTilesTogether) {
  key(Qt::Key_A, Qt::ControlModifier);
  const floor::Site before = site();
  drag(0.3, 0.3, 2.13, 1.49);
  expectAt("T-0001", 1.8, 1.2);
  expectAt("T-0006", 3.0, 1.8);
  EXPECT_EQ(steps(), 2);
  document.undoStack().undo();
  EXPECT_EQ(site(), before);
}

TEST_F(Choosing, MovesFreelyWithAlt) {
  drag(1.5, 0.9, 2.71, 0.97, Qt::AltModifier);
  expectAt("T-0006", 2.41, 0.67, 0.02);
  const double x = boxOfTile("T-0006").low.x.value();
  EXPECT_NEAR(x, std::round(x * 1000.0) / 1000.0, 1e-9) << "to the millimetre";
}

TEST_F(Choosing, RefusesToMoveATileUponAnother) {
  QSignalSpy refused{&tool, &LayTool::refused};
  const floor::Site before = site();
  drag(1.5, 0.9, 0.9, 0.9);
  EXPECT_EQ(refused.count(), 1);
  EXPECT_EQ(site(), before);
  key(Qt::Key_Left);
  EXPECT_EQ(refused.count(), 2);
  EXPECT_TRUE(refused[1][0].toString().contains("T-0005")) << refused[1][0].toString().toStdString();
  EXPECT_EQ(site(), before);
}

TEST_F(Choosing, MovesByArrowKeysByWholeTilesAndWithAltByCentimetres) {
  click(1.5, 0.9);
  key(Qt::Key_Up);
  key(Qt::Key_Right);
  expectAt("T-0006", 1.8, 1.2);
  EXPECT_EQ(steps(), 2) << "keys in a row are one step";
  key(Qt::Key_Right, Qt::AltModifier);
  expectAt("T-0006", 1.81, 1.2);
  document.undoStack().undo();
  expectAt("T-0006", 1.2, 0.6);
}

TEST_F(Choosing, TurnsOneTileInItsPlaceAndAGroupAboutItsMiddle) {
  click(0.3, 0.3);
  key(Qt::Key_R);
  EXPECT_EQ(turnsOf("T-0001"), 1);
  expectAt("T-0001", 0.0, 0.0);
  key(Qt::Key_A, Qt::ControlModifier);
  const floor::Site before = site();
  key(Qt::Key_R);
  EXPECT_EQ(turnsOf("T-0001"), 2);
  EXPECT_EQ(turnsOf("T-0002"), 1);
  const double off = std::remainder(boxOfTile("T-0001").low.x.value(), 0.6);
  EXPECT_NEAR(off, 0.0, 1e-6) << "it stays on its lattice";
  // What lay to the right of the first one lies above it now.
  EXPECT_NEAR((boxOfTile("T-0002").low.y - boxOfTile("T-0001").low.y).value(), 0.6, 1e-6);
  for (int n = 0; n < 3; ++n) key(Qt::Key_R);
  EXPECT_EQ(site(), before) << "four quarters are none";
}

TEST_F(Choosing, TurnsEachInItsPlaceWithShift) {
  key(Qt::Key_A, Qt::ControlModifier);
  key(Qt::Key_R, Qt::ShiftModifier);
  for (const floor::Placement& p : site().placements) EXPECT_EQ(p.quarterTurns, 1);
  expectAt("T-0001", 0.0, 0.0);
  expectAt("T-0006", 1.2, 0.6);
}

TEST_F(Choosing, CopiesAndPastesWithNewNumbersAndWithoutUids) {
  ASSERT_TRUE(
      document.edit("register", [](floor::Site& s) { s.tiles[1].uids = {floor::TagUid::parse("04AABBCC").value()}; }));
  drag(2.2, 0.3, 0.9, 0.3);
  ASSERT_EQ(tool.chosen(), set({"T-0002", "T-0003"}));
  key(Qt::Key_C, Qt::ControlModifier);
  key(Qt::Key_V, Qt::ControlModifier);
  EXPECT_TRUE(tool.isPasting());
  EXPECT_EQ(tiles(), 6U);
  hover(1.2, 2.1);
  click(1.2, 2.1);
  EXPECT_FALSE(tool.isPasting());
  ASSERT_EQ(tiles(), 8U);
  EXPECT_EQ(tool.chosen(), set({"T-0007", "T-0008"}));
  expectAt("T-0007", 0.6, 1.8);
  expectAt("T-0008", 1.2, 1.8);
  EXPECT_TRUE(site().tiles[6].uids.empty());
  EXPECT_EQ(site().tiles[1].uids.size(), 1U);
}

TEST_F(Choosing, PastesTurnedAndNotUponOtherTiles) {
  drag(2.2, 0.3, 0.9, 0.3);
  key(Qt::Key_C, Qt::ControlModifier);
  key(Qt::Key_V, Qt::ControlModifier);
  QSignalSpy refused{&tool, &LayTool::refused};
  click(0.9, 0.6);
  EXPECT_EQ(refused.count(), 1);
  EXPECT_EQ(tiles(), 6U);
  key(Qt::Key_R);
  click(2.1, 1.2);
  ASSERT_EQ(tiles(), 8U);
  EXPECT_EQ(turnsOf("T-0007"), 1);
  EXPECT_NEAR((boxOfTile("T-0008").low.y - boxOfTile("T-0007").low.y).value(), 0.6, 1e-6);
  key(Qt::Key_V, Qt::ControlModifier);
  key(Qt::Key_Escape);
  EXPECT_FALSE(tool.isPasting());
  EXPECT_EQ(canvas.tool(), &tool);
}

TEST_F(Choosing, BringsItsTypeAlongToAnotherSite) {
  key(Qt::Key_A, Qt::ControlModifier);
  key(Qt::Key_C, Qt::ControlModifier);
  open({});
  key(Qt::Key_V, Qt::ControlModifier);
  click(5.0, 3.0);
  EXPECT_EQ(tiles(), 6U);
  ASSERT_EQ(site().tileTypes.size(), 1U);
  EXPECT_EQ(site().tileTypes[0], floor::usualTileTypes()[0]);
}

TEST_F(Choosing, DuplicatesBesideWhereThereIsRoom) {
  drag(-0.2, 0.3, 0.9, 0.3);
  ASSERT_EQ(tool.chosen(), set({"T-0001", "T-0002"}));
  key(Qt::Key_D, Qt::ControlModifier);
  ASSERT_EQ(tiles(), 8U);
  EXPECT_EQ(tool.chosen(), set({"T-0007", "T-0008"}));
  for (const char* serial : {"T-0007", "T-0008"}) {
    const Box box = boxOfTile(serial);
    EXPECT_TRUE(box.low.x > Metres{1.79} || box.low.y > Metres{1.19}) << serial;
  }
}

TEST_F(Choosing, DeletesAndBringsBack) {
  const floor::Site before = site();
  drag(2.2, 0.3, 0.9, 0.3);
  key(Qt::Key_Delete);
  EXPECT_EQ(tiles(), 4U);
  EXPECT_EQ(site().tiles.size(), 4U);
  EXPECT_TRUE(tool.chosen().empty());
  document.undoStack().undo();
  EXPECT_EQ(site(), before);
}

TEST_F(Choosing, AlignsEdgesAndToTheNeighbours) {
  click(1.5, 0.9);
  for (int n = 0; n < 3; ++n) key(Qt::Key_Up);
  key(Qt::Key_Right, Qt::AltModifier);
  click(0.3, 0.9);
  key(Qt::Key_Up);
  click(1.5, 2.7, Qt::ControlModifier);
  ASSERT_EQ(tool.chosen(), set({"T-0004", "T-0006"}));
  tool.align(LayEdits::Line::Left);
  EXPECT_NEAR(boxOfTile("T-0006").low.x.value(), 0.0, 1e-9);
  document.undoStack().undo();
  tool.align(LayEdits::Line::Right);
  EXPECT_NEAR(boxOfTile("T-0004").high.x.value(), 1.81, 1e-9);
  document.undoStack().undo();
  tool.align(LayEdits::Line::Lattice);
  EXPECT_NEAR(boxOfTile("T-0006").low.x.value(), 1.2, 1e-9);
  expectAt("T-0004", 0.0, 1.2);
  EXPECT_EQ(boxOfTile("T-0006").low.y, boxOfTile("T-0006").low.y);
  QSignalSpy refused{&tool, &LayTool::refused};
  key(Qt::Key_A, Qt::ControlModifier);
  tool.align(LayEdits::Line::Bottom);
  EXPECT_EQ(refused.count(), 1) << "one would lie upon another";
}

TEST_F(Choosing, EscapeLeavesTheMoveThenTheChoiceThenTheTool) {
  const floor::Site before = site();
  press(1.5, 0.9);
  pull(3.0, 2.0);
  key(Qt::Key_Escape);
  release(3.0, 2.0);
  EXPECT_EQ(site(), before);
  EXPECT_EQ(tool.chosen().size(), 1U);
  key(Qt::Key_Escape);
  EXPECT_TRUE(tool.chosen().empty());
  EXPECT_EQ(canvas.tool(), &tool);
  key(Qt::Key_Escape);
  EXPECT_EQ(canvas.tool(), nullptr);
}

TEST_F(Choosing, OffersItsStepsByRightClick) {
  QTest::mouseClick(&canvas, Qt::RightButton, {}, pixel(1.5, 0.9));
  auto* menu = canvas.findChild<QMenu*>("tileMenu");
  ASSERT_NE(menu, nullptr);
  EXPECT_EQ(tool.chosen(), set({"T-0006"}));
  menu->actions().front()->trigger();
  menu->close();
  EXPECT_EQ(turnsOf("T-0006"), 1);
}

TEST_F(Choosing, ForgetsWhatAnUndoTakesAway) {
  click(1.5, 0.9);
  undoAll();
  EXPECT_TRUE(tool.chosen().empty());
}

}  // namespace
}  // namespace tessera::ui
