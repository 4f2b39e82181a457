// How revisions are joined to the window: their panel, and what differs on the floor while it is shown.
#include <QDockWidget>

#include "app/tessera/main_window.h"
#include "app/tessera/revision_desk.h"
#include "app/tessera/site_files.h"
#include "app/tessera/window_actions.h"
#include "app/tessera/window_panels.h"
#include "ui/canvas/floor_canvas.h"

namespace tessera::desktop {

void MainWindow::joinRevisions() {
  revisions_ = std::make_unique<RevisionDesk>(document_, *keeper_, settings_, *this);
  ui::RevisionPanel& panel = revisions_->panel();
  // Wide as its table is, it stands below the floor.
  QDockWidget* dock = panels_->addTool(*this, "revisionsDock", "revisions", &panel, "eventsDock");
  connect(files_, &SiteFiles::saved, revisions_.get(), &RevisionDesk::onSaved);
  connect(files_, &SiteFiles::overwriting, revisions_.get(), &RevisionDesk::keepOther);
  connect(actions_->showRevisions, &QAction::triggered, this, [this, &panel] {
    panels_->bringForward(&panel);
    panel.setFocus();
  });
  const auto showChanges = [this, dock] {
    canvas_->setChanges(!revisions_ || dock->isHidden() ? ui::ChangeMarks{} : revisions_->panel().marks());
  };
  connect(&panel, &ui::RevisionPanel::changed, this, showChanges);
  // Whoever closes the panel has done; behind another tab it compares on.
  connect(dock, &QDockWidget::visibilityChanged, this, showChanges);
  connect(&panel, &ui::RevisionPanel::told, this, &MainWindow::tell);
  connect(&panel, &ui::RevisionPanel::placeWanted, this, [this](const ui::SiteBox& place) {
    actions_->follow->setChecked(false);
    canvas_->showPlace(place);
  });
}

}  // namespace tessera::desktop
