// The calibration of readers and wheels in the main window: its panel beside the charts.
#include <QDockWidget>

#include "app/tessera/fleet_session.h"
#include "app/tessera/main_window.h"
#include "app/tessera/window_actions.h"
#include "app/tessera/window_panels.h"
#include "ui/calibrate/calibrate_panel.h"

namespace tessera::desktop {

void MainWindow::joinCalibration() {
  calibration_ = std::make_unique<ui::Calibration>(*session_, document_);
  auto* panel = new ui::CalibratePanel{*calibration_, *session_, selection_, document_};
  panels_->addTool(*this, "calibrateDock", "calibrating", panel, "chartsDock");
  connect(actions_->calibrate, &QAction::triggered, this, [this, panel] { panels_->bringForward(panel); });
  connect(panel, &ui::CalibratePanel::refused, this, &MainWindow::tell);
}

}  // namespace tessera::desktop
