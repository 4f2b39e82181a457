// Who tells whom of the site's faults in the main window.
#include <QDockWidget>
#include <QMenu>
#include <QToolButton>

#include "app/tessera/main_window.h"
#include "app/tessera/site_files.h"
#include "app/tessera/window_actions.h"
#include "app/tessera/window_panels.h"
#include "ui/base/icon.h"
#include "ui/base/wording.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/check/fault_panel.h"
#include "ui/route/route_tool.h"

namespace tessera::desktop {

void MainWindow::joinFaults() {
  const auto reveal = [this] {
    panels_->bringForward(panels_->faults);
    showFaults();
  };
  connect(actions_->showFaults, &QAction::triggered, this, reveal);
  connect(faults_, &QToolButton::clicked, this, reveal);
  connect(files_, &SiteFiles::opened, this, [this, reveal] {
    if (!document_.map()->contradictions().empty()) reveal();
  });
  connect(panels_->faults, &ui::FaultPanel::changed, this, &MainWindow::showFaults);
  connect(panels_->faults, &ui::FaultPanel::refused, this, &MainWindow::tell);
  connect(panels_->faults, &ui::FaultPanel::placeWanted, this, [this](const ui::SiteBox& place) {
    actions_->faults->setChecked(true);
    actions_->follow->setChecked(false);
    canvas_->showPlace(place);
  });
  panels_->faults->setClearance(Metres{settings_.clearance()});
  connect(panels_->faults, &ui::FaultPanel::clearanceChosen, this,
          [this](Metres clearance) { settings_.setClearance(clearance.value()); });
  connect(panels_->faults, &ui::FaultPanel::listWanted, this, [this] { panels_->bringForward(panels_->faults); });
  connect(canvas_, &ui::FloorCanvas::markMenuRequested, this, [this](int row, QPoint at) {
    QMenu* menu = panels_->faults->menuOf(row);
    if (menu == nullptr) return;
    // A mark may lie upon the vertex that somebody wants to change.
    if (canvas_->tool() != nullptr) menu->addAction(tr("&Tool’s menu here"), this, [this] { canvas_->openToolMenu(); });
    menu->popup(at);
  });
  // Whoever drives vehicles is not shown the marks: they come with the panel, those of a route also with its tool.
  connect(qobject_cast<QDockWidget*>(panels_->faults->parentWidget()), &QDockWidget::visibilityChanged, this,
          &MainWindow::showFaults);
  showFaults();
  // What is just being drawn or dragged is checked as it goes.
  connect(routeTool_.get(), &ui::CanvasTool::changed, this, [this] {
    watch_->tryRoute(routeTool_->trial());
    if (routeTool_->isBusy() != routeBusy_) markFaults();
  });
  connect(canvas_, &ui::FloorCanvas::toolChanged, this, &MainWindow::markFaults);
  connect(&selection_, &ui::Selection::routeChanged, this, &MainWindow::markFaults);
  connect(watch_.get(), &ui::FaultWatch::routeTried, this, [this](const sitecheck::Faults& faults) {
    std::vector<ui::FloorMark> marks;
    for (const sitecheck::Fault& fault : faults)
      marks.push_back({fault.place ? ui::SiteBox{fault.place->low, fault.place->high} : ui::SiteBox{},
                       fault.severity == sitecheck::Severity::Error, ui::text(fault.sentence)});
    routeTool_->setTrialFaults(std::move(marks));
  });
}

void MainWindow::showFaults() {
  const ui::FaultPanel& panel = *panels_->faults;
  auto* dock = qobject_cast<QDockWidget*>(panel.parentWidget());
  dock->setWindowTitle(panel.title());
  faults_->setText(panel.summary());
  faults_->setIcon(ui::icon(panel.summaryIcon()));
  faults_->setToolTip(tr("What is wrong with the site: click for the list"));
  markFaults();
}

void MainWindow::markFaults() {
  if (!routeTool_) return;  // the window is being taken down
  const ui::FaultPanel& panel = *panels_->faults;
  routeBusy_ = routeTool_->isBusy();
  std::optional<std::size_t> chosen;
  std::vector<ui::FloorMark> marks;
  if (!qobject_cast<QDockWidget*>(panel.parentWidget())->isHidden()) {
    marks = panel.marks(chosen);
  } else if (canvas_->tool() == routeTool_.get() && !routeBusy_ && !selection_.route().isEmpty()) {
    // While it is dragged the tool marks what would be wrong then.
    marks = panel.marks(chosen, selection_.route());
  }
  canvas_->setMarks(std::move(marks), chosen);
}

}  // namespace tessera::desktop
