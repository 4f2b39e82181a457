// The drive-over check in the main window: its panel beside the routes, its marks on the floor.
#include <QDockWidget>

#include "app/tessera/fleet_session.h"
#include "app/tessera/main_window.h"
#include "app/tessera/window_actions.h"
#include "app/tessera/window_panels.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/tilecheck/tile_check_panel.h"

namespace tessera::desktop {

void MainWindow::joinTileCheck() {
  tileWatch_ = std::make_unique<ui::TileWatch>(document_, *session_);
  auto* panel = new ui::TileCheckPanel{*tileWatch_, *session_};
  QDockWidget* dock = panels_->addTool(*this, "tileCheckDock", "drivecheck", panel);
  connect(actions_->tileCheck, &QAction::triggered, this, [this, panel] { panels_->bringForward(panel); });
  connect(panel, &ui::TileCheckPanel::refused, this, &MainWindow::tell);
  connect(panel, &ui::TileCheckPanel::placeWanted, this, [this](const ui::SiteBox& place) {
    actions_->follow->setChecked(false);
    canvas_->showPlace(place);
  });
  // Whoever drives vehicles for another reason is not shown the marks: they come with the panel.
  const auto mark = [this, dock] {
    canvas_->setTileMarks(dock->isHidden() ? std::vector<ui::TileMark>{} : tileWatch_->marks());
  };
  connect(tileWatch_.get(), &ui::TileWatch::changed, dock, mark);
  connect(dock, &QDockWidget::visibilityChanged, this, mark);
}

}  // namespace tessera::desktop
