// The floor plan under a real mouse and real keys, and what may become one.
#include <QLabel>
#include <QSignalSpy>

#include "backdrop_board.h"

namespace tessera::ui {
namespace {

using Plan = BackdropBoard;

TEST_F(Plan, liesAtTheOriginWithACentimetreAPixelAndIsSeenWhole) {
  EXPECT_EQ(backdrop().file, "hall.png");
  EXPECT_EQ(backdrop().origin, Point{});
  EXPECT_EQ(backdrop().pixel, Metres{0.01});
  EXPECT_EQ(document.undoStack().undoText(), "Add floor plan hall.png");
  canvas.setTool(nullptr);
  canvas.finishDrawing();
  const QImage shown = canvas.grab().toImage();
  const auto colour = [&](double x, double y) { return shown.pixelColor(pixel(x, y)); };
  // 4 × 2 m, the tiles of 1.8 × 1.2 m upon it.
  EXPECT_GT(colour(1.9, 1.7).blue(), colour(1.9, 1.7).red()) << "its left half";
  EXPECT_GT(colour(2.1, 1.7).red(), colour(2.1, 1.7).blue()) << "its right half";
  EXPECT_EQ(colour(0.3, 0.33), [&] {
    document.undoStack().undo();
    canvas.finishDrawing();
    return canvas.grab().toImage().pixelColor(pixel(0.3, 0.33));
  }()) << "tiles hide it";
}

TEST_F(Plan, isDraggedInOneStepAndSeenOnTheWay) {
  const int before = steps();
  QTest::mousePress(&canvas, Qt::LeftButton, {}, pixel(3, 1));
  moveTo(3.5, 1.5, Qt::LeftButton);
  ASSERT_TRUE(tool.backdrop());
  EXPECT_NEAR(tool.backdrop()->origin.x.value(), 0.5, 0.02);
  EXPECT_EQ(backdrop().origin, Point{}) << "the site changes when the button is let go";
  canvas.finishDrawing();
  EXPECT_GT(canvas.grab().toImage().pixelColor(pixel(4.2, 1.0)).red(), 100) << "where it was not before";
  moveTo(4, 2, Qt::LeftButton);
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, pixel(4, 2));
  EXPECT_EQ(steps(), before + 1);
  EXPECT_NEAR(backdrop().origin.x.value(), 1.0, 0.02);
  EXPECT_NEAR(backdrop().origin.y.value(), 1.0, 0.02);
  EXPECT_EQ(document.undoStack().undoText(), "Move floor plan");
}

TEST_F(Plan, staysWhereItWasAfterEscapeInTheMiddleOfADrag) {
  const floor::Site before = document.site();
  QTest::mousePress(&canvas, Qt::LeftButton, {}, pixel(3, 1));
  moveTo(3.5, 1.5, Qt::LeftButton);
  QTest::keyClick(&canvas, Qt::Key_Escape);
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, pixel(3.5, 1.5));
  EXPECT_EQ(document.site(), before);
  EXPECT_FALSE(tool.backdrop());
  EXPECT_EQ(canvas.tool(), &tool);
  QTest::keyClick(&canvas, Qt::Key_Escape);
  EXPECT_EQ(canvas.tool(), nullptr);
}

TEST_F(Plan, leavesADragBesideItToTheFloor) {
  const View before = canvas.view();
  drag(4.3, 1, 4.6, 1);
  EXPECT_EQ(backdrop().origin, Point{});
  EXPECT_FALSE(canvas.view() == before);
}

TEST_F(Plan, isNudgedByArrowKeysInOneStep) {
  const int before = steps();
  for (int n = 0; n < 3; ++n) QTest::keyClick(&canvas, Qt::Key_Right);
  QTest::keyClick(&canvas, Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_NEAR(backdrop().origin.x.value(), 0.03, 1e-9);
  EXPECT_NEAR(backdrop().origin.y.value(), -0.10, 1e-9);
  EXPECT_EQ(steps(), before + 1);
}

TEST_F(Plan, growsAboutTheFirstPointByTheTrueDistanceOfTwo) {
  tool.startScaling();
  QSignalSpy wanted{&tool, &BackdropTool::distanceWanted};
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, pixel(1, 1));
  EXPECT_EQ(wanted.count(), 0);
  moveTo(2, 1);
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, pixel(3, 1));
  EXPECT_EQ(wanted.count(), 1);
  ASSERT_EQ(tool.points().size(), 2U);
  const Point first = tool.points()[0];
  const double measured = tool.between()->value();
  EXPECT_NEAR(measured, 2.0, 0.02);
  const int before = steps();
  ASSERT_TRUE(tool.finishScaling(Metres{10.0}));
  EXPECT_EQ(steps(), before + 1);
  EXPECT_FALSE(tool.isScaling());
  EXPECT_NEAR(backdrop().pixel.value(), 0.01 * 10.0 / measured, 1e-12);
  // What lay under the first point lies there still: as many pixels from the corner as before.
  EXPECT_NEAR((first.x - backdrop().origin.x) / backdrop().pixel, first.x.value() / 0.01, 1e-6);
  EXPECT_NEAR((first.y - backdrop().origin.y) / backdrop().pixel, first.y.value() / 0.01, 1e-6);
  document.undoStack().undo();
  EXPECT_EQ(backdrop().pixel, Metres{0.01});
}

TEST_F(Plan, takesPointsBackAndRefusesTwoThatAreOne) {
  const floor::Site before = document.site();
  tool.startScaling();
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, pixel(1, 1));
  QTest::keyClick(&canvas, Qt::Key_Backspace);
  EXPECT_TRUE(tool.points().empty());
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, pixel(1, 1));
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, pixel(1, 1));
  const auto done = tool.finishScaling(Metres{1.0});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().sentence, "The two points are one. Click two points that lie apart.");
  QTest::keyClick(&canvas, Qt::Key_Escape);
  EXPECT_FALSE(tool.isScaling());
  EXPECT_EQ(document.site(), before);
}

TEST_F(Plan, ofAnotherFileLiesAsTheOneBefore) {
  ASSERT_TRUE(edits.move({Metres{3}, Metres{2}}));
  ASSERT_TRUE(edits.put(QStringLiteral("newer.jpg"), plan(300, 300, "JPG")));
  EXPECT_EQ(backdrop().origin, (Point{Metres{3}, Metres{2}}));
  EXPECT_EQ(backdrop().file, "newer.jpg");
  while (document.undoStack().canUndo()) document.undoStack().undo();
  EXPECT_FALSE(document.site().backdrop);
}

TEST_F(Plan, isRefusedInASentenceWhereItIsNoPicture) {
  const floor::Site before = document.site();
  const auto verdict = [&](std::string bytes) {
    const auto done = edits.put(QStringLiteral("x.png"), std::move(bytes));
    return done ? std::string{"taken"} : done.error().sentence.english();
  };
  EXPECT_EQ(verdict("GIF89a"), "x.png is neither a PNG nor a JPEG picture.");
  EXPECT_EQ(verdict(""), "x.png is neither a PNG nor a JPEG picture.");
  EXPECT_EQ(verdict(std::string(20'000'001, 'x')),
            "x.png is too large: a picture may have 20 MB. Save it smaller or as JPEG.");
  const std::string damaged = "x.png: The picture is damaged or of a kind that cannot be shown.";
  EXPECT_EQ(verdict(plan().substr(0, 60)), damaged) << "its end is missing";
  EXPECT_EQ(verdict("\xFF\xD8\xFF\xE0 and then nothing"), damaged);
  EXPECT_EQ(verdict(plan(6000, 5001)).substr(0, 44), "x.png: The picture has 6000 × 5001 pixels. ");
  EXPECT_EQ(document.site(), before);
}

TEST_F(Plan, thatWasDamagedInItsFileIsSaidToBeAndHarmsNothing) {
  floor::Site site = document.site();
  site.backdrop->picture = std::make_shared<const std::string>("\x89PNG\r\n\x1A\nnothing more");
  document.replace(floor::SiteMap::build(std::move(site)).value(), {});
  canvas.openMap(document.map());
  canvas.finishDrawing();
  EXPECT_EQ(find<QLabel>("backdropSize")->text(), "The picture is damaged or of a kind that cannot be shown.");
  drag(3, 1, 3.5, 1);
  EXPECT_EQ(backdrop().origin, Point{});
}

}  // namespace
}  // namespace tessera::ui
