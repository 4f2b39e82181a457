#include "app/tessera/window_actions.h"

#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>
#include <QUndoStack>

#include "app/tessera/languages.h"
#include "ui/base/icon.h"

namespace tessera::desktop {

WindowActions::WindowActions(QMainWindow& window, QUndoStack& steps) : QObject{&window}, steps_{steps} {
  makeAll();
  fillMenus(window);
  fillToolBar(window);
  addChoices();
  connect(&steps_, &QUndoStack::indexChanged, this, &WindowActions::nameSteps);
  retranslate();
}

QAction* WindowActions::make(const char* name, const char* icon, const QKeySequence& keys, bool checkable) {
  auto* action = new QAction{this};
  action->setObjectName(QString::fromLatin1(name));
  if (icon != nullptr) action->setIcon(ui::icon(QString::fromLatin1(icon)));
  action->setShortcut(keys);
  action->setCheckable(checkable);
  return action;
}

void WindowActions::makeAll() {
  demo = make("demo", "demo");
  newSite = make("newSite", "new", QKeySequence::New);
  open = make("open", "open", QKeySequence::Open);
  save = make("save", "save", QKeySequence::Save);
  saveAs = make("saveAs", nullptr, QKeySequence{Qt::CTRL | Qt::SHIFT | Qt::Key_S});
  properties = make("siteProperties", "settings", QKeySequence{Qt::ALT | Qt::Key_Return});
  quit = make("quit", nullptr, QKeySequence{Qt::CTRL | Qt::Key_Q});
  quit->setMenuRole(QAction::QuitRole);
  importFile = make("importFile", "import");
  exportFile = make("exportFile", "export");
  mapPicture = make("mapPicture");
  undo = make("undo", "undo", QKeySequence::Undo);
  redo = make("redo", "redo");
  redo->setShortcuts({QKeySequence{Qt::CTRL | Qt::SHIFT | Qt::Key_Z}, QKeySequence{Qt::CTRL | Qt::Key_Y}});
  find = make("find", "search", QKeySequence::Find);
  measure = make("measure", "measure", QKeySequence{Qt::CTRL | Qt::Key_M}, true);
  zoomIn = make("zoomIn", "zoom-in", QKeySequence::ZoomIn);
  zoomOut = make("zoomOut", "zoom-out", QKeySequence::ZoomOut);
  fit = make("fit", "fit", QKeySequence{Qt::CTRL | Qt::Key_0});
  follow = make("follow", "follow", QKeySequence{Qt::CTRL | Qt::Key_L}, true);
  backdrop = make("layerBackdrop", nullptr, {}, true);
  tags = make("layerTags", nullptr, {}, true);
  zones = make("layerZones", nullptr, {}, true);
  trails = make("layerTrails", nullptr, {}, true);
  uncertainty = make("layerUncertainty", nullptr, {}, true);
  grid = make("layerGrid", nullptr, {}, true);
  faults = make("layerFaults", nullptr, {}, true);
  iron = make("layerIron", nullptr, {}, true);
  browse = make("browse", "pan", QKeySequence{Qt::CTRL | Qt::Key_B}, true);
  editRoutes = make("editRoutes", "select", QKeySequence{Qt::CTRL | Qt::Key_E}, true);
  drawRoute = make("drawRoute", "route", QKeySequence{Qt::CTRL | Qt::Key_R}, true);
  editZones = make("editZones", "zone", QKeySequence{Qt::CTRL | Qt::SHIFT | Qt::Key_E}, true);
  drawZone = make("drawZone", "draw-zone", QKeySequence{Qt::CTRL | Qt::SHIFT | Qt::Key_R}, true);
  showFaults = make("showFaults", "check", QKeySequence{Qt::CTRL | Qt::SHIFT | Qt::Key_F});
  showRevisions = make("showRevisions", "revisions", QKeySequence{Qt::CTRL | Qt::Key_H});
  tileCheck = make("tileCheck", "drive-check", QKeySequence{Qt::CTRL | Qt::SHIFT | Qt::Key_D});
  locating = make("locating", "locating", QKeySequence{Qt::CTRL | Qt::SHIFT | Qt::Key_L});
  calibrate = make("calibrate", "calibrate", QKeySequence{Qt::CTRL | Qt::SHIFT | Qt::Key_K});
  compass = make("compass", "compass", QKeySequence{Qt::CTRL | Qt::SHIFT | Qt::Key_M});
  forgetIron = make("forgetIron");
  registerTags = make("registerTags", "tag", QKeySequence{Qt::CTRL | Qt::Key_T}, true);
  floorPlan = make("floorPlan", "plan", QKeySequence{Qt::CTRL | Qt::SHIFT | Qt::Key_P}, true);
  layTiles = make("layTiles", "tile", QKeySequence{Qt::CTRL | Qt::SHIFT | Qt::Key_T}, true);
  tileTypes = make("tileTypes", "grid");
  connectPort = make("connect", "connect", QKeySequence{Qt::CTRL | Qt::Key_K});
  disconnectPort = make("disconnect", "disconnect");
  radio = make("radio", "radio");
  commission = make("commission", "add");
  editVehicle = make("editVehicle", "wizard");
  jog = make("jog", "jog", QKeySequence{Qt::CTRL | Qt::Key_J});
  stopAll = make("stopAll", "stop-all");
  help = make("help", "help", QKeySequence{Qt::Key_F1});
  about = make("about", "about");
  about->setMenuRole(QAction::AboutRole);
}

void WindowActions::fillMenus(QMainWindow& window) {
  QMenuBar* bar = window.menuBar();
  site_ = bar->addMenu(QString{});
  site_->addActions({demo, newSite, open});
  recent = site_->addMenu(QString{});
  site_->addSeparator();
  site_->addActions({save, saveAs, properties});
  site_->addSeparator();
  site_->addActions({importFile, exportFile, mapPicture});
  site_->addSeparator();
  site_->addActions({showFaults, tileCheck, showRevisions});
  site_->addSeparator();
  site_->addAction(quit);
  edit_ = bar->addMenu(QString{});
  edit_->addActions({undo, redo});
  edit_->addSeparator();
  edit_->addActions({browse, editRoutes, drawRoute, layTiles});
  edit_->addSeparator();
  edit_->addActions({editZones, drawZone});
  edit_->addSeparator();
  edit_->addActions({tileTypes, registerTags, floorPlan, forgetIron});
  view_ = bar->addMenu(QString{});
  view_->addActions({zoomIn, zoomOut, fit, follow});
  view_->addSeparator();
  view_->addActions({find, measure, locating});
  view_->addSeparator();
  layers_ = view_->addMenu(QString{});
  layers_->addActions({backdrop, tags, zones, trails, uncertainty, grid, faults, iron});
  panels = view_->addMenu(QString{});
  view_->addSeparator();
  language_ = view_->addMenu(ui::icon(QStringLiteral("language")), QString{});
  appearance_ = view_->addMenu(QString{});
  vehicle_ = bar->addMenu(QString{});
  vehicle_->addActions({commission, editVehicle, calibrate, compass, jog});
  vehicle_->addSeparator();
  vehicle_->addAction(stopAll);
  connection_ = bar->addMenu(QString{});
  connection_->addActions({connectPort, disconnectPort});
  connection_->addSeparator();
  connection_->addAction(radio);
  help_ = bar->addMenu(QString{});
  help_->addActions({help, about});
  for (QAction* layer : {backdrop, tags, zones, trails, uncertainty, grid, faults}) layer->setChecked(true);
  browse->setChecked(true);
  // Reached by their keys also while the menu bar is hidden.
  for (QMenu* menu : {site_, edit_, view_, vehicle_, connection_, help_}) window.addActions(menu->actions());
}

// In the menu as well: their panel may be closed, and its keys with it.
void WindowActions::addOrders(QMainWindow& window, const QList<QAction*>& orders) {
  vehicle_->insertActions(commission, orders);
  vehicle_->insertSeparator(commission);
  window.addActions(orders);
}

void WindowActions::fillToolBar(QMainWindow& window) {
  toolBar_ = window.addToolBar(QString{});
  toolBar_->setObjectName(QStringLiteral("mainToolBar"));
  toolBar_->setMovable(false);
  toolBar_->setContextMenuPolicy(Qt::PreventContextMenu);
  toolBar_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  toolBar_->addActions({open, save});
  toolBar_->addSeparator();
  toolBar_->addActions({undo, redo});
  toolBar_->addSeparator();
  toolBar_->addActions({browse, editRoutes, drawRoute, layTiles, editZones});
  toolBar_->addSeparator();
  toolBar_->addActions({zoomIn, zoomOut, fit, follow});
  toolBar_->addSeparator();
  toolBar_->addActions({connectPort, disconnectPort});
}

void WindowActions::addChoices() {
  languages = new QActionGroup{this};
  for (const Language& language : Languages::all()) {
    QAction* action = languages->addAction(language.name);
    action->setObjectName(QStringLiteral("language_") + language.code);
    action->setData(language.code);
    action->setCheckable(true);
  }
  language_->addActions(languages->actions());
  connect(languages, &QActionGroup::triggered, this,
          [this](QAction* action) { Q_EMIT languageChosen(action->data().toString()); });
  appearances = new QActionGroup{this};
  for (const Appearance appearance : {Appearance::System, Appearance::Light, Appearance::Dark}) {
    QAction* action = appearances->addAction(QString{});
    action->setObjectName(QStringLiteral("appearance_") + nameOf(appearance));
    action->setData(static_cast<int>(appearance));
    action->setCheckable(true);
  }
  appearance_->addActions(appearances->actions());
  connect(appearances, &QActionGroup::triggered, this,
          [this](QAction* action) { Q_EMIT appearanceChosen(static_cast<Appearance>(action->data().toInt())); });
}

}  // namespace tessera::desktop
