// The calibrations of readers and wheels, and of the compass, in the main window: their panels beside the charts.
#include <QDockWidget>

#include "app/tessera/fleet_session.h"
#include "app/tessera/main_window.h"
#include "app/tessera/window_actions.h"
#include "app/tessera/window_panels.h"
#include "ui/calibrate/calibrate_panel.h"
#include "ui/calibrate/compass_panel.h"

namespace tessera::desktop {

void MainWindow::joinCalibration() {
  calibration_ = std::make_unique<ui::Calibration>(*session_, document_);
  auto* panel = new ui::CalibratePanel{*calibration_, *session_, selection_, document_};
  panels_->addTool(*this, "calibrateDock", "calibrating", panel, "chartsDock");
  connect(actions_->calibrate, &QAction::triggered, this, [this, panel] { panels_->bringForward(panel); });
  connect(panel, &ui::CalibratePanel::refused, this, &MainWindow::tell);
  survey_ = std::make_unique<ui::CompassSurvey>(*session_);
  auto* compass = new ui::CompassPanel{*survey_, *session_, selection_, document_};
  panels_->addTool(*this, "compassDock", "compass", compass, "chartsDock");
  connect(actions_->compass, &QAction::triggered, this, [this, compass] { panels_->bringForward(compass); });
  connect(
      survey_.get(), &ui::CompassSurvey::changed, this,
      [this] {
        if (!closesLater_ || survey_->writes()) return;
        closesLater_ = false;
        if (survey_->tone() == ui::Notice::Tone::Good)
          close();
        else
          tell(survey_->message());
      },
      Qt::QueuedConnection);
}

// Half old, half new values would stay in the vehicle, and nobody else knows the old ones. Where writing fails the
// window stays, as only here they can be brought back.
bool MainWindow::closesWhenWritten() {
  closesLater_ = survey_->writes();
  if (closesLater_) tell(tr("The compass' values are being written into the vehicle; then the window closes."));
  return closesLater_;
}

}  // namespace tessera::desktop
