// How a vehicle is located, in the main window: the panel beside the charts, its drawing upon the floor.
#include <QDockWidget>

#include "app/tessera/fleet_session.h"
#include "app/tessera/main_window.h"
#include "app/tessera/truth_probe.h"
#include "app/tessera/window_actions.h"
#include "app/tessera/window_panels.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/locating/locating_panel.h"

namespace tessera::desktop {

void MainWindow::joinLocating() {
  truth_ = std::make_unique<TruthProbe>(*session_);
  auto* panel = new ui::LocatingPanel{*session_, selection_, document_, *truth_};
  panels_->addTool(*this, "locatingDock", "locating", panel, "chartsDock");
  canvas_->setOverlay(&panel->overlay());
  connect(panel, &ui::LocatingPanel::overlayChanged, canvas_, &ui::FloorCanvas::overlayChanged);
  connect(actions_->locating, &QAction::triggered, this, [this, panel] { panels_->bringForward(panel); });
}

}  // namespace tessera::desktop
