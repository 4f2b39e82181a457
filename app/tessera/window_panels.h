// The panels around the floor: which there are, where they stand at first, and their titles.
#pragma once

#include <QObject>
#include <QPointer>
#include <vector>

#include "ui/base/fleet_link.h"
#include "ui/base/selection.h"
#include "ui/base/site_document.h"

class QDockWidget;
class QMainWindow;
class QUndoView;

namespace tessera::ui {
class EventPanel;
class FaultPanel;
class FaultWatch;
class LayTool;
class LiveCharts;
class RoutePanel;
class RunPanel;
class TilePanel;
class VehicleTable;
class ZonePanel;
}  // namespace tessera::ui

namespace tessera::desktop {

class WindowPanels : public QObject {
  Q_OBJECT
public:
  WindowPanels(QMainWindow& window, ui::FleetLink& fleet, ui::Selection& selection, ui::SiteDocument& document,
               ui::LayTool& layTool, ui::FaultWatch& watch);

  ui::VehicleTable* vehicles;
  ui::RunPanel* run;
  ui::RoutePanel* routes;
  ui::TilePanel* tiles;
  ui::LiveCharts* charts;
  ui::EventPanel* events;
  QUndoView* steps;  ///< all since the site was opened; a click goes back to one
  ui::ZonePanel* zones;
  ui::FaultPanel* faults;

  /// The panel of a tool: a tab beside the routes, or another dock, hidden until the tool is chosen. Its title is the
  /// content's window title.
  QDockWidget* addTool(QMainWindow& window, const char* name, const char* topic, QWidget* content,
                       const char* beside = "routesDock");
  [[nodiscard]] const std::vector<QDockWidget*>& docks() const { return docks_; }
  /// Shown together with the floor, hidden behind the start page.
  void setShown(bool shown);
  void retranslate();
  /// A panel that belongs to a tool, in front of those in the same place.
  void bringForward(QWidget* panel);
  /// Heights and widths of a first start, when the panels are shown next.
  void arrangeWhenShown() { unarranged_ = true; }

protected:
  [[nodiscard]] bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QDockWidget* add(QMainWindow& window, const char* name, const char* topic, Qt::DockWidgetArea area, QWidget* content);
  void arrange(QMainWindow& window);

  std::vector<QDockWidget*> docks_;
  std::vector<QDockWidget*> hidden_;
  bool shown_ = true;
  bool unarranged_ = false;
};

}  // namespace tessera::desktop
