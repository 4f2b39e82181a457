// Laying tiles with the mouse: one by one, along a stroke, a rectangle at once.
#include "laying_board.h"

namespace tessera::ui {
namespace {

class Laying : public LayingBoard {};

TEST_F(Laying, PaintsSixByFourTilesInStrokesThatSnapToOneLattice) {
  for (int row = 0; row < 4; ++row) drag(0.25, 0.33 + 0.6 * row, 3.4, 0.25 + 0.6 * row);
  EXPECT_EQ(tiles(), 24U);
  EXPECT_EQ(steps(), 4);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 6; ++column) {
      const std::string serial = tileAt(0.3 + 0.6 * column, 0.3 + 0.6 * row);
      ASSERT_FALSE(serial.empty()) << column << ", " << row;
      expectAt(serial, 0.6 * column, 0.6 * row);
    }
  }
  EXPECT_EQ(site().tiles.front().serial, "T-0001");
  EXPECT_EQ(site().tiles.back().serial, "T-0024");
}

TEST_F(Laying, LaysOnlyWhenTheButtonIsLetGoAndAsOneStep) {
  press(0.3, 0.3);
  pull(2.1, 0.3);
  EXPECT_EQ(tiles(), 0U);
  EXPECT_EQ(steps(), 0);
  release(2.1, 0.3);
  EXPECT_EQ(tiles(), 4U) << "none left out by a quick hand";
  EXPECT_EQ(steps(), 1);
  EXPECT_TRUE(stepText().contains("4")) << stepText().toStdString();
}

TEST_F(Laying, FillsARectangleWithShift) {
  drag(0.3, 0.3, 3.3, 2.1, Qt::ShiftModifier);
  EXPECT_EQ(tiles(), 24U);
  EXPECT_EQ(steps(), 1);
  expectAt("T-0001", 0.0, 0.0);
  expectAt("T-0024", 3.0, 1.8);
}

TEST_F(Laying, FillsInAnyDirection) {
  drag(3.3, 2.1, 2.1, 0.3, Qt::ShiftModifier);
  EXPECT_EQ(tiles(), 12U);
  EXPECT_FALSE(tileAt(2.1, 0.3).empty());
}

TEST_F(Laying, NeverLaysATileUponAnother) {
  fill(3, 2);
  drag(0.3, 0.3, 2.7, 2.1, Qt::ShiftModifier);
  EXPECT_EQ(tiles(), 5U * 4U);
  drag(0.3, 0.3, 2.7, 0.3);
  click(1.0, 1.0);
  EXPECT_EQ(tiles(), 20U);
  EXPECT_EQ(steps(), 2);
}

TEST_F(Laying, SnapsToWhereTheNeighboursLieAndNotToTheOrigin) {
  press(2.0, 2.0, Qt::AltModifier);
  release(2.0, 2.0, Qt::AltModifier);
  ASSERT_EQ(tiles(), 1U);
  const Box first = boxOfTile("T-0001");
  click(2.6, 1.9);
  expectAt("T-0002", first.high.x.value(), first.low.y.value());
  click(1.5, 2.6);
  expectAt("T-0003", first.low.x.value() - 0.6, first.low.y.value() + 0.6);
}

TEST_F(Laying, LaysTilesOfAnotherSizeEdgeToEdge) {
  ASSERT_TRUE(document.edit("add", [](floor::Site& s) { s.tileTypes.push_back(floor::usualTileTypes()[6]); }));
  fill(2, 1);
  tool.setBrush(floor::usualTileTypes()[6].name);  // 30 cm
  click(1.38, 0.12);
  ASSERT_EQ(tiles(), 3U);
  EXPECT_NEAR(site().placements.back().origin.x.value(), 1.2, 1e-9);
  EXPECT_NEAR(site().placements.back().origin.y.value(), 0.0, 1e-9);
}

TEST_F(Laying, TurnsWhatIsLaidNext) {
  key(Qt::Key_R);
  EXPECT_EQ(tool.brushTurns(), 1);
  click(0.3, 0.3);
  EXPECT_EQ(turnsOf("T-0001"), 1);
  expectAt("T-0001", 0.0, 0.0);
}

TEST_F(Laying, LeavesTheStrokeByEscapeAndByUndo) {
  press(0.3, 0.3);
  pull(2.1, 0.3);
  key(Qt::Key_Escape);
  release(2.1, 0.3);
  EXPECT_EQ(tiles(), 0U);
  EXPECT_EQ(canvas.tool(), &tool);
  press(0.3, 0.3);
  pull(2.1, 0.3);
  EXPECT_TRUE(canvas.undoInTool());
  release(2.1, 0.3);
  EXPECT_EQ(tiles(), 0U);
  EXPECT_FALSE(canvas.undoInTool()) << "the document's turn";
  key(Qt::Key_Escape);
  EXPECT_EQ(canvas.tool(), nullptr);
}

TEST_F(Laying, NumbersByTheRule) {
  tool.setRule({"Hall-", 2, 7});
  drag(0.3, 0.3, 0.9, 0.3);
  EXPECT_EQ(site().tiles[0].serial, "Hall-07");
  EXPECT_EQ(site().tiles[1].serial, "Hall-08");
}

TEST_F(Laying, GoesOnWithTheNumbersOfTheSite) {
  floor::Site other = floor::layNewFloor({"Hall", floor::usualTileTypes()[0], 2, 2, true}).value();
  for (auto& tile : other.tiles) tile.serial = "B" + tile.serial.substr(2);
  for (auto& placement : other.placements) placement.serial = "B" + placement.serial.substr(2);
  open(other);
  click(1.4, 0.3);
  EXPECT_EQ(site().tiles.back().serial, "B0005");
}

TEST_F(Laying, SaysThatATypeIsMissing) {
  open({});
  QSignalSpy refused{&tool, &LayTool::refused};
  click(0.3, 0.3);
  EXPECT_EQ(refused.count(), 1);
  EXPECT_EQ(tiles(), 0U);
  EXPECT_TRUE(tool.brush().empty());
  ASSERT_TRUE(document.edit("add", [](floor::Site& s) { s.tileTypes = {floor::usualTileTypes()[1]}; }));
  EXPECT_EQ(tool.brush(), floor::usualTileTypes()[1].name);
}

TEST_F(Laying, RefusesARectangleOfMoreTilesThanOneStepMayLay) {
  QSignalSpy refused{&tool, &LayTool::refused};
  press(0.3, 0.3, Qt::ShiftModifier);
  pull(400.0, 400.0, Qt::ShiftModifier);
  release(0.3, 0.3, Qt::ShiftModifier);
  EXPECT_EQ(refused.count(), 1);
  EXPECT_EQ(tiles(), 0U);
}

TEST_F(Laying, PansByTheMiddleButtonAndZoomsMeanwhile) {
  const Point before = canvas.view().centre();
  QTest::mousePress(&canvas, Qt::MiddleButton, {}, {500, 400});
  QTest::mouseMove(&canvas, {450, 380});
  QTest::mouseRelease(&canvas, Qt::MiddleButton, {}, {450, 380});
  EXPECT_NE(canvas.view().centre(), before);
  EXPECT_EQ(tiles(), 0U);
}

TEST_F(Laying, SaysWhatToDoNext) {
  QSignalSpy hints{&canvas, &FloorCanvas::hintChanged};
  const QString first = tool.hint();
  key(Qt::Key_C);
  EXPECT_NE(tool.hint(), first);
  EXPECT_EQ(hints.last()[0].toString(), tool.hint());
}

}  // namespace
}  // namespace tessera::ui
