// Who tells whom in the main window.
#include <QApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QSerialPortInfo>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <algorithm>

#include "app/tessera/fleet_session.h"
#include "app/tessera/keeper.h"
#include "app/tessera/main_window.h"
#include "app/tessera/radio_workbench.h"
#include "app/tessera/site_files.h"
#include "app/tessera/window_actions.h"
#include "app/tessera/window_panels.h"
#include "store/database.h"
#include "ui/base/wording.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/charts/live_charts.h"
#include "ui/commission/commission_wizard.h"
#include "ui/commission/jog_dialog.h"
#include "ui/connect/connect_dialog.h"
#include "ui/connect/radio_dialog.h"
#include "ui/connect/start_page.h"
#include "ui/fleet/event_panel.h"
#include "ui/fleet/run_panel.h"
#include "ui/fleet/vehicle_table.h"
#include "ui/help/about_dialog.h"
#include "ui/lay/lay_tool.h"
#include "ui/route/route_panel.h"
#include "ui/route/route_tool.h"
#include "ui/site/site_dialog.h"

namespace tessera::desktop {

void MainWindow::joinSite() {
  connect(&document_, &ui::SiteDocument::replaced, this, [this] { canvas_->openMap(document_.map()); });
  connect(&document_, &ui::SiteDocument::changed, this, [this] {
    canvas_->setMap(document_.map());
    session_->useSite(document_.map());
    forgetSelectionThatIsGone();
  });
  connect(&document_, &ui::SiteDocument::changed, this, &MainWindow::showSite);
  connect(&document_, &ui::SiteDocument::pathChanged, this, &MainWindow::showSite);
  connect(&document_, &ui::SiteDocument::modifiedChanged, this, &MainWindow::showSite);
  connect(files_, &SiteFiles::opened, this, [this] {
    // Vehicles of another site are none of this one's.
    session_->disconnectGently();
    open_ = true;
    useTool(nullptr);
    showSite();
    showFleetState();
    canvas_->fit();  // it has its size only now
    const auto& site = document_.site();
    selection_.setVehicle(site.vehicles.empty() ? std::nullopt : std::optional{site.vehicles.front().id});
    selection_.setRoute(site.routes.empty() ? QString{} : QString::fromStdString(site.routes.front().name));
    selection_.setZone({});
    showRecent();
  });
  connect(files_, &SiteFiles::saved, keeper_, &Keeper::onSaved);
  connect(files_, &SiteFiles::givenUp, keeper_, &Keeper::onGivenUp);
  files_->setRecovery([this](const QString& path) { return keeper_->unsaved(path); });
  files_->setSharing([this](const QString& path) { return keeper_->holderOf(path); });
  files_->setHomeless([this] {
    std::vector<SiteFiles::Homeless> sites;
    for (const auto& kept : keeper_->homeless())
      sites.push_back(
          {QString::fromStdString(kept.key), QLocale{}.toString(kept.when, QLocale::ShortFormat), kept.map});
    return sites;
  });
  connect(files_, &SiteFiles::takenUp, keeper_, [this](const QString& key) { keeper_->goOnAs(key.toStdString()); });
  connect(files_, &SiteFiles::forgotten, keeper_, [this](const QString& key) { keeper_->forget(key.toStdString()); });
  connect(keeper_, &Keeper::failed, this, &MainWindow::tell);
  connect(start_, &ui::StartPage::demoRequested, this, &MainWindow::openDemo);
  connect(start_, &ui::StartPage::newRequested, files_, &SiteFiles::create);
  connect(start_, &ui::StartPage::openRequested, files_, &SiteFiles::openAsking);
  connect(start_, &ui::StartPage::recentRequested, files_, &SiteFiles::open);
  connect(start_, &ui::StartPage::forgetRequested, this, [this](const QString& path) {
    settings_.forgetRecent(path);
    showRecent();
  });
}

void MainWindow::joinFleet() {
  connect(session_, &ui::FleetLink::snapshotChanged, this, [this] {
    const auto snapshot = session_->latest();
    canvas_->setSnapshot(snapshot);
    // Without a picture of the fleet there is still the state of the session to tell.
    if (!snapshot) return showFleetState();
    const auto port = ui::text(snapshot->port.sentence);
    if (port != port_->text()) port_->setText(port);
  });
  connect(session_, &FleetSession::stateChanged, this, &MainWindow::showFleetState);
  connect(session_, &ui::FleetLink::eventsArrived, this, &MainWindow::takeUpKeys);
  connect(files_, &SiteFiles::saved, this, [this] { session_->keysAreFiled(document_.site()); });
  connect(session_, &FleetSession::failed, this, &MainWindow::tell);
  connect(session_, &FleetSession::worldComplained, this,
          [this](const QString& line) { statusBar()->showMessage(tr("Simulated world: %1").arg(line), 15'000); });
  connect(canvas_, &ui::FloorCanvas::vehiclePicked, &selection_,
          [this](VehicleId vehicle) { selection_.setVehicle(vehicle); });
  connect(canvas_, &ui::FloorCanvas::routePicked, &selection_, &ui::Selection::setRoute);
  connect(&selection_, &ui::Selection::vehicleChanged, this, [this] {
    canvas_->setSelectedVehicle(selection_.vehicle());
    if (actions_->follow->isChecked()) canvas_->follow(selection_.vehicle());
    actions_->editVehicle->setEnabled(selection_.vehicle().has_value());
  });
  connect(&selection_, &ui::Selection::routeChanged, this, [this] { canvas_->setSelectedRoute(selection_.route()); });
  connect(canvas_, &ui::FloorCanvas::pointed, this, [this](std::optional<Point> point) {
    if (!point) {
      place_->clear();
      return;
    }
    const QLocale locale;
    place_->setText(
        tr("x %1 m, y %2 m").arg(locale.toString(point->x.value(), 'f', 2), locale.toString(point->y.value(), 'f', 2)));
  });
}

void MainWindow::joinActions() {
  const auto& a = *actions_;
  connect(a.demo, &QAction::triggered, this, &MainWindow::openDemo);
  connect(a.newSite, &QAction::triggered, files_, &SiteFiles::create);
  connect(a.open, &QAction::triggered, files_, &SiteFiles::openAsking);
  connect(a.save, &QAction::triggered, files_, &SiteFiles::save);
  connect(a.saveAs, &QAction::triggered, files_, &SiteFiles::saveAs);
  connect(a.properties, &QAction::triggered, this, [this] { ui::SiteDialog{document_, this}.exec(); });
  connect(a.quit, &QAction::triggered, this, &QWidget::close);
  connect(a.zoomIn, &QAction::triggered, canvas_, &ui::FloorCanvas::zoomIn);
  connect(a.zoomOut, &QAction::triggered, canvas_, &ui::FloorCanvas::zoomOut);
  connect(a.fit, &QAction::triggered, canvas_, &ui::FloorCanvas::fit);
  connect(a.follow, &QAction::toggled, this,
          [this](bool on) { canvas_->follow(on ? selection_.vehicle() : std::nullopt); });
  connect(a.drawRoute, &QAction::triggered, this, &MainWindow::drawRoute);
  connect(a.editRoutes, &QAction::triggered, this, [this] { useTool(routeTool_.get()); });
  connect(a.browse, &QAction::triggered, this, [this] { useTool(nullptr); });
  connect(a.undo, &QAction::triggered, this, [this] {
    if (!canvas_->undoInTool()) document_.undoStack().undo();
  });
  connect(a.redo, &QAction::triggered, this, [this] {
    if (!canvas_->redoInTool()) document_.undoStack().redo();
  });
  connect(a.connectPort, &QAction::triggered, this, &MainWindow::askConnection);
  connect(a.disconnectPort, &QAction::triggered, session_, &FleetSession::disconnectGently);
  connect(a.stopAll, &QAction::triggered, this, [this] { session_->post(supervisor::StopAll{}); });
  connect(a.help, &QAction::triggered, this, &MainWindow::showHelp);
  connect(a.about, &QAction::triggered, this, [this] {
    ui::AboutDialog{this, QString::fromStdString(store::sqliteVersion())}.exec();
  });
  connect(a.commission, &QAction::triggered, this, [this] { commission(std::nullopt); });
  connect(a.editVehicle, &QAction::triggered, this, [this] { commission(selection_.vehicle()); });
  connect(a.radio, &QAction::triggered, this, &MainWindow::openRadio);
  connect(a.jog, &QAction::triggered, this, [this] {
    auto* dialog = new ui::JogDialog{*session_, selection_, this};
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
  });
  const auto layer = [this](QAction* action, bool ui::CanvasLayers::*which) {
    connect(action, &QAction::toggled, this, [this, which](bool on) {
      auto layers = canvas_->layers();
      layers.*which = on;
      canvas_->setLayers(layers);
    });
  };
  layer(a.backdrop, &ui::CanvasLayers::backdrop);
  layer(a.tags, &ui::CanvasLayers::tags);
  layer(a.zones, &ui::CanvasLayers::zones);
  layer(a.trails, &ui::CanvasLayers::trails);
  layer(a.uncertainty, &ui::CanvasLayers::uncertainty);
  layer(a.grid, &ui::CanvasLayers::grid);
  layer(a.faults, &ui::CanvasLayers::faults);
  layer(a.iron, &ui::CanvasLayers::iron);
  connect(actions_, &WindowActions::languageChosen, this, &MainWindow::setLanguage);
  connect(actions_, &WindowActions::appearanceChosen, this, &MainWindow::setAppearance);
  connect(a.recent, &QMenu::triggered, this, [this](QAction* action) { files_->open(action->data().toString()); });
}

void MainWindow::joinPanels() {
  for (QDockWidget* dock : panels_->docks()) actions_->panels->addAction(dock->toggleViewAction());
  connect(panels_->vehicles, &ui::VehicleTable::connectRequested, this, &MainWindow::askConnection);
  connect(panels_->vehicles, &ui::VehicleTable::commissionRequested, this, [this] { commission(std::nullopt); });
  connect(panels_->vehicles, &ui::VehicleTable::followRequested, this, [this](VehicleId vehicle) {
    selection_.setVehicle(vehicle);
    actions_->follow->setChecked(true);
  });
  connect(panels_->run, &ui::RunPanel::drawRouteRequested, this, &MainWindow::drawRoute);
  connect(panels_->run, &ui::RunPanel::commissionRequested, this, [this] { commission(std::nullopt); });
  connect(panels_->routes, &ui::RoutePanel::drawRequested, this, &MainWindow::drawRoute);
  connect(routeTool_.get(), &ui::RouteTool::finished, this,
          [this](const QString& route) { selection_.setRoute(route); });
  connect(routeTool_.get(), &ui::RouteTool::refused, this, &MainWindow::tell);
  connect(routeTool_.get(), &ui::CanvasTool::changed, this, &MainWindow::showTool);
  connect(routeTool_.get(), &ui::RouteTool::vertexChanged, panels_->routes, &ui::RoutePanel::setVertex);
  connect(panels_->routes, &ui::RoutePanel::vertexSelected, routeTool_.get(), &ui::RouteTool::setVertex);
  connect(panels_->routes, &ui::RoutePanel::refused, this, &MainWindow::tell);
  connect(canvas_, &ui::FloorCanvas::toolChanged, this, &MainWindow::showTool);
  connect(canvas_, &ui::FloorCanvas::hintChanged, hint_, [this](const QString& hint) {
    hint_->setText(hint);
    hint_->setToolTip(hint);
  });
  panels_->events->setClock(&Keeper::wallClock);
  connect(keeper_, &Keeper::historyLoaded, panels_->events, &ui::EventPanel::prepend);
  connect(panels_->events, &ui::EventPanel::dayWanted, keeper_, &Keeper::readDay);
  connect(keeper_, &Keeper::dayRead, panels_->events, &ui::EventPanel::showDay);
  connect(keeper_, &Keeper::dayFailed, panels_->events, &ui::EventPanel::showDayFailure);
}

void MainWindow::showSite() {
  centre_->setCurrentIndex(open_ ? centre_->indexOf(canvas_) : 0);
  panels_->setShown(open_);
  for (QAction* action : {actions_->importFile, actions_->exportFile, actions_->mapPicture,    actions_->find,
                          actions_->measure,    actions_->save,       actions_->saveAs,        actions_->properties,
                          actions_->zoomIn,     actions_->zoomOut,    actions_->fit,           actions_->follow,
                          actions_->browse,     actions_->editRoutes, actions_->drawRoute,     actions_->editZones,
                          actions_->drawZone,   actions_->showFaults, actions_->showRevisions, actions_->registerTags,
                          actions_->layTiles,   actions_->tileTypes,  actions_->connectPort,   actions_->radio,
                          actions_->commission, actions_->jog,        actions_->floorPlan,     actions_->tileCheck,
                          actions_->locating,   actions_->calibrate,  actions_->compass})
    action->setEnabled(open_);
  actions_->editVehicle->setEnabled(open_ && selection_.vehicle().has_value());
  faults_->setVisible(open_);
  setWindowFilePath(document_.path());
  const QString name = QString::fromStdString(document_.site().name);
  // The title has the place for the star before anything may set it.
  setWindowTitle(open_ ? tr("%1[*] – Tessera").arg(name.isEmpty() ? tr("Unnamed site") : name)
                       : tr("Tessera") + QStringLiteral("[*]"));
  setWindowModified(document_.isModified());
}

void MainWindow::showFleetState() {
  const auto state = session_->state();
  actions_->disconnectPort->setEnabled(state != FleetSession::State::Off);
  port_->setToolTip({});
  switch (state) {
    case FleetSession::State::Off:
      port_->setText(tr("Not connected"));
      port_->setToolTip(open_ ? tr("Connection › Connect… (Ctrl+K) takes the vehicles under supervision.") : QString{});
      break;
    case FleetSession::State::Starting:
      port_->setText(tr("The simulated world is being set up…"));
      break;
    case FleetSession::State::Stopping:
      port_->setText(tr("The vehicles are being stopped…"));
      break;
    case FleetSession::State::Resting:
      port_->setText(tr("The radio module is being set"));
      break;
    case FleetSession::State::Live:
      break;
  }
}

void MainWindow::showRecent() {
  std::vector<ui::RecentSite> sites;
  actions_->recent->clear();
  for (const QString& path : settings_.recent()) {
    const QFileInfo file{path};
    QAction* action = actions_->recent->addAction(file.fileName());
    action->setData(path);
    action->setToolTip(path);
    action->setEnabled(file.exists());
    sites.push_back(ui::RecentSite{file.completeBaseName().remove(QStringLiteral(".tessera")), path,
                                   file.lastModified(), !file.exists()});
  }
  actions_->recent->setEnabled(!sites.empty());
  start_->setRecent(std::move(sites));
}

void MainWindow::forgetSelectionThatIsGone() {
  if (selection_.vehicle() && document_.map()->vehicle(*selection_.vehicle()) == nullptr)
    selection_.setVehicle(std::nullopt);
  if (document_.map()->route(selection_.route().toStdString()) == nullptr) {
    const auto& routes = document_.site().routes;
    selection_.setRoute(routes.empty() ? QString{} : QString::fromStdString(routes.front().name));
  }
}

void MainWindow::openDemo() {
  if (files_->openDemo()) session_->connectTo({}, document_.map());
}

}  // namespace tessera::desktop
