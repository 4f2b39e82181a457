#include "app/tessera/window_panels.h"

#include <QChildEvent>
#include <QDockWidget>
#include <QMainWindow>
#include <QTabBar>
#include <QTimer>
#include <QUndoView>
#include <algorithm>
#include <utility>

#include "ui/charts/live_charts.h"
#include "ui/check/fault_panel.h"
#include "ui/fleet/event_panel.h"
#include "ui/fleet/run_panel.h"
#include "ui/fleet/vehicle_table.h"
#include "ui/lay/tile_panel.h"
#include "ui/route/route_panel.h"
#include "ui/zone/zone_panel.h"

namespace tessera::desktop {

WindowPanels::WindowPanels(QMainWindow& window, ui::FleetLink& fleet, ui::Selection& selection,
                           ui::SiteDocument& document, ui::LayTool& layTool, ui::FaultWatch& watch)
    : QObject{&window} {
  vehicles = new ui::VehicleTable{fleet, selection, document};
  run = new ui::RunPanel{fleet, selection, document};
  routes = new ui::RoutePanel{document, selection};
  tiles = new ui::TilePanel{document, layTool};
  charts = new ui::LiveCharts{fleet, selection, document};
  events = new ui::EventPanel{fleet, selection, document};
  window.setDockNestingEnabled(true);
  window.installEventFilter(this);
  window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  auto* vehicleDock = add(window, "vehiclesDock", "vehicles", Qt::BottomDockWidgetArea, vehicles);
  auto* chartDock = add(window, "chartsDock", "charts", Qt::BottomDockWidgetArea, charts);
  auto* eventDock = add(window, "eventsDock", "events", Qt::BottomDockWidgetArea, events);
  window.tabifyDockWidget(vehicleDock, chartDock);
  window.tabifyDockWidget(chartDock, eventDock);
  vehicleDock->raise();
  add(window, "runDock", "running", Qt::RightDockWidgetArea, run);
  auto* routesDock = add(window, "routesDock", "routes", Qt::RightDockWidgetArea, routes);
  // Shown when its tool is taken in hand: who only drives never sees it.
  auto* tilesDock = add(window, "tilesDock", "tiles", Qt::RightDockWidgetArea, tiles);
  window.tabifyDockWidget(routesDock, tilesDock);
  tilesDock->hide();
  zones = new ui::ZonePanel{document, selection};
  auto* zoneDock = add(window, "zonesDock", "zones", Qt::RightDockWidgetArea, zones);
  window.tabifyDockWidget(tilesDock, zoneDock);
  zoneDock->hide();
  faults = new ui::FaultPanel{document, watch};
  auto* faultDock = add(window, "faultsDock", "checking", Qt::BottomDockWidgetArea, faults);
  window.tabifyDockWidget(eventDock, faultDock);
  faultDock->hide();
  steps = new QUndoView{&document.undoStack()};
  addTool(window, "stepsDock", "exchange", steps);
  retranslate();
}

// The window makes its tab bars as it needs them, and would shorten names to a few letters: rather arrows at the end.
bool WindowPanels::eventFilter(QObject* watched, QEvent* event) {
  const auto* child = event->type() == QEvent::ChildPolished ? dynamic_cast<QChildEvent*>(event) : nullptr;
  auto* tabs = child != nullptr ? qobject_cast<QTabBar*>(child->child()) : nullptr;
  if (tabs != nullptr) tabs->setElideMode(Qt::ElideNone);
  return QObject::eventFilter(watched, event);
}

QDockWidget* WindowPanels::add(QMainWindow& window, const char* name, const char* topic, Qt::DockWidgetArea area,
                               QWidget* content) {
  auto* dock = new QDockWidget{&window};
  dock->setObjectName(QString::fromLatin1(name));
  dock->setProperty("helpTopic", QString::fromLatin1(topic));
  dock->setWidget(content);
  window.addDockWidget(area, dock);
  docks_.push_back(dock);
  return dock;
}

QDockWidget* WindowPanels::addTool(QMainWindow& window, const char* name, const char* topic, QWidget* content,
                                   const char* beside) {
  auto* neighbour = window.findChild<QDockWidget*>(QString::fromLatin1(beside));
  auto* dock = add(window, name, topic, window.dockWidgetArea(neighbour), content);
  dock->setWindowTitle(content->windowTitle());
  connect(content, &QWidget::windowTitleChanged, dock, &QWidget::setWindowTitle);
  window.tabifyDockWidget(neighbour, dock);
  dock->hide();
  return dock;
}

void WindowPanels::setShown(bool shown) {
  if (shown == shown_) return;
  shown_ = shown;
  if (!shown) {
    hidden_.clear();
    for (QDockWidget* dock : docks_) {
      // A dock behind another tab is not visible but not hidden either.
      if (!dock->isHidden()) hidden_.push_back(dock);
      dock->hide();
    }
    return;
  }
  for (QDockWidget* dock : hidden_) dock->show();
  if (!std::exchange(unarranged_, false)) return;
  auto* window = qobject_cast<QMainWindow*>(parent());
  // What is hidden has no size to give: only from the event loop on have the panels one.
  QTimer::singleShot(0, this, [this, window] { arrange(*window); });
}

void WindowPanels::bringForward(QWidget* panel) {
  for (QDockWidget* dock : docks_) {
    if (dock->widget() != panel) continue;
    dock->show();
    dock->raise();
  }
}

void WindowPanels::arrange(QMainWindow& window) {
  const int line = window.fontMetrics().height();
  window.resizeDocks({docks_[0]}, {17 * line}, Qt::Vertical);
  window.resizeDocks({docks_[3], docks_[4]}, {19 * line, 22 * line}, Qt::Vertical);
  window.resizeDocks({docks_[3]}, {18 * line}, Qt::Horizontal);
}

void WindowPanels::retranslate() {
  steps->setWindowTitle(tr("Steps"));
  steps->setEmptyLabel(tr("As it was opened"));
  const QStringList titles{tr("Vehicles"), tr("Charts"), tr("What happened"), tr("Drive"),
                           tr("Routes"),   tr("Tiles"),  tr("Zones"),         faults->title()};
  for (std::size_t i = 0; i < static_cast<std::size_t>(titles.size()); ++i)
    docks_[i]->setWindowTitle(titles.at(static_cast<qsizetype>(i)));
}

}  // namespace tessera::desktop
