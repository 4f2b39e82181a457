// Registering tags in the main window: its panel beside the routes, its tool on the floor.
#include <QDockWidget>
#include <algorithm>

#include "app/tessera/main_window.h"
#include "app/tessera/register_desk.h"
#include "app/tessera/window_actions.h"
#include "app/tessera/window_panels.h"

namespace tessera::desktop {

void MainWindow::joinRegister() {
  register_ = std::make_unique<RegisterDesk>(document_, *keeper_, *canvas_);
  QDockWidget* dock = panels_->addTool(*this, "registerDock", "registering", &register_->panel());
  connect(actions_->registerTags, &QAction::triggered, this, [this, dock] {
    dock->show();
    dock->raise();
    // The tile is to be seen from where its tags are.
    const int line = fontMetrics().height();
    resizeDocks({dock}, {std::max(dock->height(), 38 * line)}, Qt::Vertical);
    resizeDocks({dock}, {std::max(dock->width(), 20 * line)}, Qt::Horizontal);
    useTool(&register_->tool());
  });
}

}  // namespace tessera::desktop
