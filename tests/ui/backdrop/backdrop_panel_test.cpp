// The floor plan's panel under keys and mouse.
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>

#include "backdrop_board.h"
#include "tests/ui/connect/look.h"

namespace tessera::ui {
namespace {

class PlanPanel : public BackdropBoard {
protected:
  void SetUp() override {
    BackdropBoard::SetUp();
    panel.resize(320, 520);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  }
  void type(const char* name, const QString& number) {
    auto* box = find<QDoubleSpinBox>(name);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, number);
    QTest::keyClick(box, Qt::Key_Return);
  }
};

TEST_F(PlanPanel, asksForAPictureWhereThereIsNone) {
  EXPECT_FALSE(find<QPushButton>("chooseBackdrop")->isVisible());
  QTest::mouseClick(find<QPushButton>("removeBackdrop"), Qt::LeftButton);
  EXPECT_FALSE(document.site().backdrop);
  EXPECT_EQ(document.undoStack().undoText(), "Remove floor plan");
  ASSERT_TRUE(find<QPushButton>("chooseBackdrop")->isVisible());
  QSignalSpy wanted{&panel, &BackdropPanel::pictureWanted};
  QTest::mouseClick(find<QPushButton>("chooseBackdrop"), Qt::LeftButton);
  EXPECT_EQ(wanted.count(), 1);
  document.undoStack().undo();
  EXPECT_FALSE(find<QPushButton>("chooseBackdrop")->isVisible());
}

TEST_F(PlanPanel, setsPlaceDirectionAndScaleByNumbersEachInAStep) {
  const int before = steps();
  type("backdropX", "1.5");
  type("backdropY", "-2");
  type("backdropTurn", "90");
  type("backdropPixel", "25");
  EXPECT_EQ(steps(), before + 4);
  EXPECT_EQ(backdrop().origin, (Point{Metres{1.5}, Metres{-2}}));
  EXPECT_EQ(backdrop().turn, fromDegrees(90));
  EXPECT_EQ(backdrop().pixel, Metres{0.025});
  EXPECT_EQ(find<QLabel>("backdropSize")->text(), "400 × 200 pixels, 10.00 × 5.00 m");
  type("backdropX", "1.6");
  type("backdropX", "1.7");
  EXPECT_EQ(steps(), before + 6) << "each number that is typed is a step";
  QTest::keyClick(find<QDoubleSpinBox>("backdropX"), Qt::Key_Up);
  QTest::keyClick(find<QDoubleSpinBox>("backdropX"), Qt::Key_Up);
  EXPECT_NEAR(backdrop().origin.x.value(), 1.9, 1e-9);
  EXPECT_EQ(steps(), before + 7) << "and turning it on is one";
  while (document.undoStack().index() > before) document.undoStack().undo();
  EXPECT_EQ(find<QDoubleSpinBox>("backdropX")->value(), 0.0);
  EXPECT_EQ(backdrop().pixel, Metres{0.01});
}

TEST_F(PlanPanel, makesOneStepOfAWholeDragOfItsSlider) {
  const int before = steps();
  auto* slider = find<QSlider>("backdropOpacity");
  EXPECT_EQ(slider->value(), 50);
  slider->setFocus();
  for (int n = 0; n < 5; ++n) QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_NEAR(backdrop().opacity, 0.55, 1e-9);
  EXPECT_EQ(steps(), before + 1);
  document.undoStack().undo();
  EXPECT_EQ(slider->value(), 50);
}

TEST_F(PlanPanel, scalesByTwoPointsWithTheDistanceTypedAfterTheSecond) {
  auto* distance = find<QDoubleSpinBox>("backdropDistance");
  EXPECT_FALSE(distance->isVisible());
  QTest::mouseClick(find<QPushButton>("scaleBackdrop"), Qt::LeftButton);
  ASSERT_TRUE(tool.isScaling());
  ASSERT_TRUE(distance->isVisible());
  EXPECT_FALSE(distance->isEnabled());
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, pixel(0, 1));
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, pixel(4, 1));
  ASSERT_TRUE(distance->isEnabled());
  EXPECT_NEAR(distance->value(), 4.0, 0.02);
  const double measured = tool.between()->value();
  type("backdropDistance", "40");
  EXPECT_NEAR(backdrop().pixel.value(), 0.4 / measured, 1e-9);
  EXPECT_FALSE(distance->isVisible());
  EXPECT_TRUE(find<QPushButton>("scaleBackdrop")->isVisible());
}

TEST_F(PlanPanel, givesScalingUpByEscapeAlsoInItsNumber) {
  const floor::Site before = document.site();
  QTest::mouseClick(find<QPushButton>("scaleBackdrop"), Qt::LeftButton);
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, pixel(0, 1));
  QTest::mouseClick(&canvas, Qt::LeftButton, {}, pixel(4, 1));
  panel.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel));
  auto* distance = find<QDoubleSpinBox>("backdropDistance");
  distance->setFocus();
  QTest::keyClick(distance, Qt::Key_Escape);
  EXPECT_FALSE(tool.isScaling());
  EXPECT_EQ(document.site(), before);
}

TEST_F(PlanPanel, hasAPictureInLightAndDark) {
  for (const bool dark : {false, true}) {
    look::setDark(dark);
    look::take(panel, dark ? "floorplan-dark" : "floorplan-light");
    tool.startScaling();
    look::take(panel, dark ? "floorplan-scaling-dark" : "floorplan-scaling-light");
    tool.cancel();
  }
  look::setDark(false);
}

}  // namespace
}  // namespace tessera::ui
