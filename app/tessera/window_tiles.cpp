// How laying tiles is joined to the window.

#include "app/tessera/main_window.h"
#include "app/tessera/window_actions.h"
#include "app/tessera/window_panels.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/lay/lay_tool.h"
#include "ui/lay/tile_panel.h"
#include "ui/lay/tile_types_dialog.h"

namespace tessera::desktop {

void MainWindow::joinTiles() {
  connect(actions_->layTiles, &QAction::triggered, this, &MainWindow::layTiles);
  connect(actions_->tileTypes, &QAction::triggered, this, &MainWindow::editTileTypes);
  connect(panels_->tiles, &ui::TilePanel::typesRequested, this, &MainWindow::editTileTypes);
  connect(panels_->tiles, &ui::TilePanel::toolRequested, this, [this] { useTool(layTool_.get()); });
  connect(layTool_.get(), &ui::LayTool::refused, this, &MainWindow::tell);
  connect(layTool_.get(), &ui::LayTool::settingsChanged, this, &MainWindow::showTool);
}

void MainWindow::layTiles() {
  useTool(layTool_.get());
  panels_->bringForward(panels_->tiles);
  canvas_->setFocus();
}

void MainWindow::editTileTypes() {
  ui::TileTypesDialog dialog{document_, this};
  dialog.showType(layTool_->brush());
  dialog.exec();
}

}  // namespace tessera::desktop
