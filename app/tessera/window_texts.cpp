// The words of menus and tool bar, set again whenever the language changes.
#include <QRegularExpression>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>

#include "app/tessera/window_actions.h"

namespace tessera::desktop {

void WindowActions::retranslate() {
  site_->setTitle(tr("&Site"));
  edit_->setTitle(tr("&Edit"));
  view_->setTitle(tr("&View"));
  vehicle_->setTitle(tr("Veh&icle"));
  connection_->setTitle(tr("&Connection"));
  help_->setTitle(tr("&Help"));
  recent->setTitle(tr("Open &recent"));
  layers_->setTitle(tr("&Shown on the floor"));
  panels->setTitle(tr("&Panels"));
  language_->setTitle(tr("&Language"));
  appearance_->setTitle(tr("&Appearance"));
  toolBar_->setWindowTitle(tr("Tools"));

  demo->setText(tr("&Demo floor"));
  newSite->setText(tr("&New…"));
  open->setText(tr("&Open…"));
  save->setText(tr("&Save"));
  saveAs->setText(tr("Save &as…"));
  properties->setText(tr("Properties of the si&te…"));
  importFile->setText(tr("&Import…"));
  exportFile->setText(tr("&Export…"));
  mapPicture->setText(tr("&Picture of the map…"));
  quit->setText(tr("&Quit"));
  zoomIn->setText(tr("Zoom &in"));
  zoomOut->setText(tr("Zoom &out"));
  fit->setText(tr("&Whole floor"));
  follow->setText(tr("&Follow the vehicle"));
  find->setText(tr("&Go to…"));
  measure->setText(tr("&Measure"));
  backdrop->setText(tr("Floor &plan"));
  tags->setText(tr("&Tags"));
  zones->setText(tr("&Zones"));
  trails->setText(tr("T&rails"));
  uncertainty->setText(tr("&Uncertainty"));
  grid->setText(tr("&Grid"));
  faults->setText(tr("&Faults"));
  iron->setText(tr("&Iron in the floor"));
  iron->setToolTip(tr("By how much iron turns compasses, as vehicles have learned it"));
  browse->setText(tr("&Look around"));
  editRoutes->setText(tr("&Change routes"));
  drawRoute->setText(tr("&Draw a route"));
  editZones->setText(tr("Change &zones"));
  drawZone->setText(tr("Draw a z&one"));
  showFaults->setText(tr("&Faults of the site"));
  showRevisions->setText(tr("Re&visions"));
  tileCheck->setText(tr("Dri&ve-over check…"));
  calibrate->setText(tr("Calibrate readers and &wheels…"));
  compass->setText(tr("Calibrate the co&mpass…"));
  locating->setText(tr("Loc&ating of the vehicle…"));
  registerTags->setText(tr("Register &tags…"));
  floorPlan->setText(tr("Floor &plan…"));
  forgetIron->setText(tr("Forget the &magnetic map…"));
  layTiles->setText(tr("Lay t&iles"));
  tileTypes->setText(tr("Tile t&ypes…"));
  connectPort->setText(tr("&Connect…"));
  disconnectPort->setText(tr("&Disconnect"));
  radio->setText(tr("&Radio module of this computer…"));
  commission->setText(tr("&Set up a new vehicle…"));
  editVehicle->setText(tr("&Change the chosen vehicle…"));
  jog->setText(tr("Drive by &hand…"));
  stopAll->setText(tr("Stop a&ll (F12)"));
  help->setText(tr("&Help for this view"));
  about->setText(tr("&About Tessera"));
  nameSteps();
  const QStringList appearanceNames{tr("As the &desktop"), tr("&Light"), tr("D&ark")};
  for (int i = 0; i < appearanceNames.size(); ++i) appearances->actions().at(i)->setText(appearanceNames.at(i));

  disconnectPort->setToolTip(tr("Stop all vehicles, then close the port"));
  follow->setToolTip(
      tr("Keep the chosen vehicle in view (%1)").arg(follow->shortcut().toString(QKeySequence::NativeText)));
  drawRoute->setToolTip(
      tr("Click the route's vertices on the floor (%1)").arg(drawRoute->shortcut().toString(QKeySequence::NativeText)));
  editZones->setToolTip(tr("Change zones on the floor and in their panel (%1)")
                            .arg(editZones->shortcut().toString(QKeySequence::NativeText)));
  layTiles->setToolTip(tr("Lay tiles on the floor, choose and move them (%1)")
                           .arg(layTiles->shortcut().toString(QKeySequence::NativeText)));
  // Buttons have no letter to press: the menus have, and one letter must not mean two things.
  static const QRegularExpression letter{QStringLiteral("\\(&.\\)|&")};
  for (QAction* action : {browse, editRoutes, drawRoute, layTiles, connectPort, disconnectPort})
    action->setIconText(QString{action->text()}.remove(letter));
  // What everybody knows by its picture needs no word beside it.
  for (QAction* action : {open, save, undo, redo, zoomIn, zoomOut, fit, follow, editZones}) {
    if (auto* button = qobject_cast<QToolButton*>(toolBar_->widgetForAction(action))) {
      button->setToolButtonStyle(Qt::ToolButtonIconOnly);
      button->setAccessibleName(QString{action->text()}.remove(letter));
    }
  }
}

void WindowActions::allowSteps(bool inTool) {
  stepsInTool_ = inTool;
  nameSteps();
}

void WindowActions::nameSteps() {
  undo->setEnabled(stepsInTool_ || steps_.canUndo());
  redo->setEnabled(stepsInTool_ || steps_.canRedo());
  undo->setText(!stepsInTool_ && steps_.canUndo() ? tr("&Undo: %1").arg(steps_.undoText()) : tr("&Undo"));
  redo->setText(!stepsInTool_ && steps_.canRedo() ? tr("&Redo: %1").arg(steps_.redoText()) : tr("&Redo"));
}

}  // namespace tessera::desktop
