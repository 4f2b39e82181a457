// Which tool is in hand on the floor, and who tells whom of the zones.
#include "app/tessera/backdrop_desk.h"
#include "app/tessera/main_window.h"
#include "app/tessera/register_desk.h"
#include "app/tessera/window_actions.h"
#include "app/tessera/window_panels.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/lay/lay_tool.h"
#include "ui/measure/measure_tool.h"
#include "ui/route/route_tool.h"
#include "ui/zone/zone_panel.h"
#include "ui/zone/zone_tool.h"

namespace tessera::desktop {

void MainWindow::useTool(ui::CanvasTool* tool) {
  canvas_->setTool(tool);
  canvas_->setFocus();
  showTool();
}

void MainWindow::drawRoute() {
  useTool(routeTool_.get());
  routeTool_->startDrawing();
}

void MainWindow::showTool() {
  const bool routes = canvas_->tool() == routeTool_.get();
  const bool drawing = routes && routeTool_->isDrawing();
  const bool zones = canvas_->tool() == zoneTool_.get();
  const bool outlining = zones && zoneTool_->isDrawing();
  actions_->browse->setChecked(canvas_->tool() == nullptr);
  actions_->registerTags->setChecked(register_ && canvas_->tool() == &register_->tool());
  actions_->floorPlan->setChecked(backdrop_ && canvas_->tool() == &backdrop_->tool());
  actions_->measure->setChecked(measureTool_ && canvas_->tool() == measureTool_.get());
  actions_->layTiles->setChecked(canvas_->tool() == layTool_.get());
  actions_->editZones->setChecked(zones && !outlining);
  actions_->drawZone->setChecked(outlining);
  actions_->editRoutes->setChecked(routes && !drawing);
  actions_->drawRoute->setChecked(drawing);
  actions_->allowSteps((drawing && !routeTool_->draft().empty()) || layTool_->isPasting() ||
                       (outlining && !zoneTool_->draft().empty()) || isMeasuring() ||
                       (backdrop_ && canvas_->tool() == &backdrop_->tool() && !backdrop_->tool().points().empty()));
}

bool MainWindow::isMeasuring() const {
  return measureTool_ && canvas_->tool() == measureTool_.get() && !measureTool_->points().empty() &&
         !measureTool_->isComplete();
}

void MainWindow::joinZones() {
  connect(actions_->editZones, &QAction::triggered, this, &MainWindow::useZoneTool);
  const auto draw = [this](floor::ZoneKind kind) {
    useZoneTool();
    zoneTool_->setKind(kind);
    zoneTool_->startDrawing();
  };
  // The first zone of a floor is the one that vehicles drive in, the next ones restrict it.
  connect(actions_->drawZone, &QAction::triggered, this,
          [this, draw] { draw(document_.site().zones.empty() ? floor::ZoneKind::Running : floor::ZoneKind::NoGo); });
  connect(panels_->zones, &ui::ZonePanel::drawRequested, this, draw);
  connect(panels_->zones, &ui::ZonePanel::zoneActivated, this, [this] {
    if (canvas_->tool() == zoneTool_.get()) return;
    canvas_->setTool(zoneTool_.get());  // the list keeps the keys
    actions_->zones->setChecked(true);
  });
  connect(zoneTool_.get(), &ui::ZoneTool::refused, this, &MainWindow::tell);
  connect(zoneTool_.get(), &ui::CanvasTool::changed, this, &MainWindow::showTool);
  connect(zoneTool_.get(), &ui::ZoneTool::cornerChanged, panels_->zones, &ui::ZonePanel::setCorner);
  connect(panels_->zones, &ui::ZonePanel::cornerSelected, zoneTool_.get(), &ui::ZoneTool::setCorner);
  connect(panels_->zones, &ui::ZonePanel::refused, this, &MainWindow::tell);
}

void MainWindow::useZoneTool() {
  actions_->zones->setChecked(true);
  panels_->bringForward(panels_->zones);
  useTool(zoneTool_.get());
}

}  // namespace tessera::desktop
