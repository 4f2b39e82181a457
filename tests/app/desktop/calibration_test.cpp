// The calibrations in the whole window, over the simulated world: the figure is drawn, driven and recorded; the compass
// is measured by turning.
#include <QAbstractItemView>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>

#include "app/desktop/desktop_fixture.h"
#include "ui/calibrate/calibrate_panel.h"
#include "ui/connect/look.h"
#include "ui/fleet/event_model.h"
#include "ui/fleet/event_panel.h"

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

TEST_F(CalibrationInWindow, measuresTheCompassByTurningAndKeepsTheSamplesOutOfTheEvents) {
  openWindow(false);
  ASSERT_NO_FATAL_FAILURE(startDemo());
  window->selection().setVehicle(VehicleId{1});
  press(Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(until([&] { return find("turnForSurvey")->isVisible() && find("turnForSurvey")->isEnabled(); }));
  QTest::mouseClick(find("turnForSurvey"), Qt::LeftButton);
  const auto* figures = find<QLabel>("surveyFigures");
  ASSERT_TRUE(until([&] { return figures->text().startsWith(QStringLiteral("8 of 64")); })) << "while it turns";
  EXPECT_EQ(vehicle().state, wire::VehicleState::Calibrating);
  const auto* result = find<QLabel>("surveyResult");
  ASSERT_TRUE(QTest::qWaitFor([&] { return figures->text().startsWith(QStringLiteral("Hard iron")); }, 90'000))
      << figures->text().toStdString() << result->text().toStdString();
  EXPECT_TRUE(figures->text().contains(QStringLiteral("24 of 24"))) << figures->text().toStdString();
  EXPECT_TRUE(result->text().startsWith(QStringLiteral("The values in the vehicle"))) << result->text().toStdString();
  ui::look::take(*window, QStringLiteral("compass-window"));
  const auto* events = window->findChild<ui::EventPanel*>();
  ASSERT_NE(events, nullptr);
  const QAbstractItemModel* listed = events->findChild<QAbstractItemView*>()->model();
  EXPECT_GT(listed->rowCount(), 0);
  int told = 0;
  for (int row = 0; row < listed->rowCount(); ++row)
    told +=
        listed->index(row, ui::EventModel::What).data().toString().contains(QStringLiteral("in a direction")) ? 1 : 0;
  EXPECT_EQ(told, 0);

  QTest::mouseClick(find("writeSurvey"), Qt::LeftButton);
  window->close();
  EXPECT_TRUE(window->isVisible()) << "half of the values are old ones";
  ASSERT_TRUE(until([&] { return !window->isVisible(); })) << result->text().toStdString();
  EXPECT_TRUE(result->text().startsWith(QStringLiteral("Written"))) << result->text().toStdString();
}

}  // namespace
}  // namespace tessera::desktop
