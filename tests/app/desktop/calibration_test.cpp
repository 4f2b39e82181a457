// The calibration in the whole window: the figure is drawn, driven and recorded over the simulated world.
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>

#include "app/desktop/desktop_fixture.h"
#include "ui/calibrate/calibrate_panel.h"
#include "ui/connect/look.h"

namespace tessera::desktop {
namespace {

class CalibrationInWindow : public DesktopTest {};

TEST_F(CalibrationInWindow, drawsTheFigureAndRecordsTheDriveAlongIt) {
  openWindow(false);
  ASSERT_NO_FATAL_FAILURE(startDemo());
  window->selection().setVehicle(VehicleId{1});
  EXPECT_TRUE(find<QDockWidget>("calibrateDock")->isHidden());
  press(Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(until([&] { return find("drawFigure")->isVisible() && find("recordCalibration")->isEnabled(); }));
  QTest::mouseClick(find("drawFigure"), Qt::LeftButton);
  EXPECT_EQ(window->selection().route(), "Calibration");
  QTest::mouseClick(find("recordCalibration"), Qt::LeftButton);
  pressWhenOffered("runAction", Qt::Key_F5);
  ASSERT_TRUE(until([&] { return vehicle().task == supervisor::Task::Running; })) << vehicle().waits.english();
  EXPECT_EQ(vehicle().route, "Calibration");
  const auto* table = find<QTableWidget>("calibrateTable");
  ASSERT_TRUE(until([&] { return table->rowCount() == 2 * 3 + 1; })) << "enough reads for an estimate";
  window->canvas().finishDrawing();
  ui::look::take(*window, QStringLiteral("calibrate-window"));
  press(Qt::Key_F12);
  QTest::mouseClick(find("recordCalibration"), Qt::LeftButton);
  EXPECT_TRUE(until([&] { return window->session().latest()->watched == nullptr; }));
}

}  // namespace
}  // namespace tessera::desktop
