// Drawing zones with mouse and keys.
#include "zone_board.h"

namespace tessera::ui {
namespace {

using ZoneDrawing = ZoneBoard;

TEST_F(ZoneDrawing, DrawsAPolygonByClicksAndEndsOnItsFirstCorner) {
  QSignalSpy finished{&tool, &ZoneTool::finished};
  tool.setKind(floor::ZoneKind::Slow);
  tool.startDrawing();
  for (const auto& [x, y] : {std::pair{1.8, 0.6}, {2.4, 0.6}, {2.4, 1.2}, {1.8, 0.6}}) click(x, y);
  ASSERT_EQ(zones(), 3U);
  EXPECT_EQ(zone(2).kind, floor::ZoneKind::Slow);
  EXPECT_EQ(zone(2).speed, ZoneEdits::kUsualSpeed);
  EXPECT_EQ(zone(2).outline, (std::vector{placeAt(1.8, 0.6), placeAt(2.4, 0.6), placeAt(2.4, 1.2)}));
  EXPECT_EQ(selection.zone(), "Slow zone 1");
  EXPECT_EQ(finished.count(), 1);
  EXPECT_FALSE(tool.isDrawing());
  EXPECT_EQ(steps(), 1);
  EXPECT_EQ(document.undoStack().undoText(), "Draw Slow zone 1");
  document.undoStack().undo();
  EXPECT_EQ(zones(), 2U);
}

TEST_F(ZoneDrawing, DrawsARectangleByADragAndSnapsToTiles) {
  tool.startDrawing();
  drag(pixel(1.80, 1.20) + QPoint{3, -4}, pixel(2.40, 1.80) + QPoint{-4, 3});
  ASSERT_EQ(zones(), 3U);
  EXPECT_EQ(zone(2).outline, (std::vector{placeAt(1.8, 1.2), placeAt(2.4, 1.2), placeAt(2.4, 1.8), placeAt(1.8, 1.8)}));
  EXPECT_EQ(steps(), 1);
}

TEST_F(ZoneDrawing, EndsByDoubleClickAndByEnter) {
  tool.startDrawing();
  click(1.8, 0.6);
  click(2.4, 0.6);
  QTest::mouseDClick(&canvas, Qt::LeftButton, {}, pixel(2.4, 1.2));
  ASSERT_EQ(zones(), 3U);
  EXPECT_EQ(zone(2).outline.size(), 3U);
  tool.startDrawing();
  for (const auto& [x, y] : {std::pair{0.6, 0.6}, {1.2, 0.6}, {1.2, 0.75}, {0.6, 0.75}}) click(x, y);
  key(Qt::Key_Return);
  ASSERT_EQ(zones(), 4U);
  EXPECT_EQ(zone(3).outline.size(), 4U);
}

TEST_F(ZoneDrawing, RefusesWhatEnclosesNoFloor) {
  QSignalSpy refused{&tool, &ZoneTool::refused};
  tool.startDrawing();
  click(0.6, 0.6);
  click(1.2, 0.6);
  key(Qt::Key_Return);
  EXPECT_EQ(refused.count(), 1);
  click(1.8, 0.6);
  key(Qt::Key_Return);
  EXPECT_EQ(refused.count(), 2);
  EXPECT_EQ(steps(), 0);
  EXPECT_EQ(tool.draft().size(), 3U) << "what was drawn is there to go on with";
}

TEST_F(ZoneDrawing, TakesBackClickByClickAndRedoes) {
  tool.startDrawing();
  for (const auto& [x, y] : {std::pair{0.6, 0.6}, {1.2, 0.6}, {1.2, 1.2}}) click(x, y);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(tool.draft().size(), 2U);
  key(Qt::Key_Backspace);
  EXPECT_EQ(tool.draft().size(), 1U);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(tool.draft().size(), 3U);
  EXPECT_EQ(steps(), 0);
}

TEST_F(ZoneDrawing, EscapeDropsTheOutlineThenTheDrawingAndWithItTheTool) {
  tool.startDrawing();
  click(0.6, 0.6);
  key(Qt::Key_Escape);
  EXPECT_TRUE(tool.draft().empty());
  EXPECT_TRUE(tool.isDrawing());
  key(Qt::Key_Escape);
  EXPECT_EQ(canvas.tool(), nullptr);
  EXPECT_EQ(steps(), 0);
}

TEST_F(ZoneDrawing, EscapeDropsARectangleInTheMiddleOfItsDrag) {
  tool.startDrawing();
  QTest::mousePress(&canvas, Qt::LeftButton, {}, pixel(1.8, 1.2));
  moveTo(pixel(2.2, 1.5), {});
  key(Qt::Key_Escape);
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, pixel(2.2, 1.5));
  EXPECT_EQ(zones(), 2U);
  EXPECT_TRUE(tool.draft().empty());
  EXPECT_TRUE(tool.isDrawing());
}

TEST_F(ZoneDrawing, HoldsEdgesTo45DegreesWithShift) {
  tool.startDrawing();
  click(0.6, 0.6);
  click(1.23, 0.66, Qt::ShiftModifier);
  ASSERT_EQ(tool.draft().size(), 2U);
  EXPECT_EQ(tool.draft()[1].y, Metres{0.6});
}

TEST_F(ZoneDrawing, SnapsToTheCornersOfOtherZones) {
  tool.startDrawing();
  click(2.71, 2.09);
  ASSERT_EQ(tool.draft().size(), 1U);
  EXPECT_EQ(tool.draft()[0], placeAt(2.7, 2.1));
}

TEST_F(ZoneDrawing, BeginsFromTheMenuWhereItWasOpened) {
  QTest::mouseClick(&canvas, Qt::RightButton, {}, pixel(1.8, 1.8));
  auto* menu = canvas.findChild<QMenu*>("zoneMenu");
  ASSERT_NE(menu, nullptr);
  menu->actions().last()->trigger();
  menu->close();
  EXPECT_TRUE(tool.isDrawing());
  EXPECT_EQ(tool.draft(), (std::vector{placeAt(1.8, 1.8)}));
}

}  // namespace
}  // namespace tessera::ui
