// Everything that can be done from the main window's menus and its tool bar: names, icons, keys.
#pragma once

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QObject>
#include <vector>

#include "app/tessera/appearance.h"

class QMainWindow;
class QToolBar;
class QUndoStack;

namespace tessera::desktop {

class WindowActions : public QObject {
  Q_OBJECT
public:
  /// Puts menus and the tool bar into the window. The actions live as long as the window.
  WindowActions(QMainWindow& window, QUndoStack& steps);

  QAction *demo, *newSite, *open, *save, *saveAs, *properties, *quit;
  QAction *importFile, *exportFile, *mapPicture;
  QAction *undo, *redo;
  QAction *find, *measure;
  QAction *zoomIn, *zoomOut, *fit, *follow, *backdrop, *tags, *zones, *trails, *uncertainty, *grid, *faults, *iron;
  QAction *drawRoute, *editRoutes, *layTiles, *tileTypes, *browse;
  QAction *drawZone, *editZones, *showFaults, *showRevisions;
  QAction *registerTags, *floorPlan, *tileCheck, *locating, *calibrate, *compass, *forgetIron;
  QAction *connectPort, *disconnectPort, *radio;
  QAction *commission, *editVehicle, *jog, *stopAll;
  QAction *help, *about;
  QMenu *recent, *panels;
  QActionGroup *languages, *appearances;

  [[nodiscard]] QToolBar& toolBar() { return *toolBar_; }
  /// What a vehicle is told to do, for the vehicle's menu.
  void addOrders(QMainWindow& window, const QList<QAction*>& orders);
  void retranslate();
  /// The tool has steps of its own to undo and redo.
  void allowSteps(bool inTool);

Q_SIGNALS:
  void languageChosen(const QString& code);
  void appearanceChosen(tessera::desktop::Appearance appearance);

private:
  QAction* make(const char* name, const char* icon = nullptr, const QKeySequence& keys = {}, bool checkable = false);
  void makeAll();
  void fillMenus(QMainWindow& window);
  void fillToolBar(QMainWindow& window);
  void addChoices();
  void nameSteps();

  QUndoStack& steps_;
  bool stepsInTool_ = false;
  QMenu *site_, *edit_, *view_, *vehicle_, *connection_, *help_, *language_, *appearance_, *layers_;
  QToolBar* toolBar_;
};

}  // namespace tessera::desktop
