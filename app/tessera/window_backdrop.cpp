// The picture beneath the floor in the main window: its panel beside the routes, its tool on the floor.
#include <QDockWidget>

#include "app/tessera/backdrop_desk.h"
#include "app/tessera/main_window.h"
#include "app/tessera/window_actions.h"
#include "app/tessera/window_panels.h"
#include "ui/canvas/floor_canvas.h"

namespace tessera::desktop {

void MainWindow::joinBackdrop() {
  backdrop_ = std::make_unique<BackdropDesk>(document_, *canvas_, *this);
  QDockWidget* dock = panels_->addTool(*this, "backdropDock", "floorplan", &backdrop_->panel());
  connect(actions_->floorPlan, &QAction::triggered, this, [this, dock] {
    actions_->backdrop->setChecked(true);  // what is hidden cannot be laid
    dock->show();
    dock->raise();
    useTool(&backdrop_->tool());
  });
  connect(&backdrop_->panel(), &ui::BackdropPanel::refused, this, &MainWindow::tell);
  connect(&backdrop_->tool(), &ui::CanvasTool::changed, this, &MainWindow::showTool);
}

}  // namespace tessera::desktop
