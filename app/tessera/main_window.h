// The window: the floor in the middle, panels around it, the stop button always in reach. It joins the parts and knows
// what none of them needs to know of the others.
#pragma once

#include <QMainWindow>
#include <QPointer>
#include <memory>
#include <optional>

#include "app/tessera/languages.h"
#include "app/tessera/settings.h"
#include "supervisor/event.h"
#include "ui/base/connection_choice.h"
#include "ui/base/selection.h"
#include "ui/base/site_document.h"

class QLabel;
class QStackedWidget;
class QToolButton;

namespace tessera::ui {
class Calibration;
class CompassSurvey;
class CanvasTool;
class FindBox;
class MeasureTool;
class FaultWatch;
class FloorCanvas;
class HelpWindow;
class LayTool;
class RouteTool;
class StartPage;
class StopAllButton;
class StopAllKey;
class TileWatch;
class ZoneTool;
}  // namespace tessera::ui

namespace tessera::desktop {

class BackdropDesk;
class ExchangeFiles;
class FleetSession;
class Keeper;
class MagneticDesk;
class RegisterDesk;
class RevisionDesk;
class SiteFiles;
class TruthProbe;
class WindowActions;
class WindowPanels;

class MainWindow : public QMainWindow {
  Q_OBJECT
public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] ui::SiteDocument& document() { return document_; }
  [[nodiscard]] ui::Selection& selection() { return selection_; }
  [[nodiscard]] FleetSession& session() { return *session_; }
  [[nodiscard]] SiteFiles& files() { return *files_; }
  [[nodiscard]] ui::FloorCanvas& canvas() { return *canvas_; }
  [[nodiscard]] RegisterDesk& registerDesk() { return *register_; }
  [[nodiscard]] BackdropDesk& floorPlan() { return *backdrop_; }
  [[nodiscard]] MagneticDesk& magneticDesk() { return *magnetic_; }
  [[nodiscard]] ui::TileWatch& tileWatch() { return *tileWatch_; }
  [[nodiscard]] Keeper& keeper() { return *keeper_; }

  /// Window, panels, language and appearance as they were.
  void restore();
  /// The site that was open, or one that was left behind unsaved; asks where it must, so the event loop has to run.
  void reopen();
  void setLanguage(const QString& code);
  void setAppearance(Appearance appearance);
  /// Opens the demo floor and supervises its simulated vehicles.
  void openDemo();
  void connectTo(const ui::ConnectionChoice& choice);
  /// Ends without asking anybody anything, as when the computer is shut down. What is not saved is offered again at the
  /// next start.
  void endUnasked();

protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void buildCentre();
  void buildStatusBar();
  void joinSite();
  void joinFleet();
  void joinActions();
  void joinPanels();
  void joinLooking();
  [[nodiscard]] bool isMeasuring() const;
  void showSite();
  void showFleetState();
  void showRecent();
  void forgetSelectionThatIsGone();
  void useTool(ui::CanvasTool* tool);
  void drawRoute();
  void useZoneTool();
  void joinZones();
  void joinFaults();
  void showFaults();
  void markFaults();
  void joinRegister();
  void joinRevisions();
  void joinBackdrop();
  void joinTileCheck();
  void joinLocating();
  void joinMagnetic();
  void joinCalibration();
  void layTiles();
  void editTileTypes();
  void joinTiles();
  void showTool();
  [[nodiscard]] std::optional<ui::ConnectionChoice> chooseConnection();
  void askConnection();
  void openRadio();
  void commission(std::optional<VehicleId> vehicle);
  void takeUpKeys(const std::vector<supervisor::Event>& events);
  [[nodiscard]] bool closesWhenWritten();
  void tellUnconfirmed(const QStringList& vehicles);
  void tell(const QString& sentence);
  void showHelp();
  void retranslate();

  Settings settings_;
  Languages languages_;
  ui::SiteDocument document_;
  ui::Selection selection_;
  FleetSession* session_;
  Keeper* keeper_;
  SiteFiles* files_;
  WindowActions* actions_;
  QStackedWidget* centre_;
  ui::StartPage* start_;
  ui::FloorCanvas* canvas_;
  std::unique_ptr<ui::FaultWatch> watch_;
  std::unique_ptr<ui::TileWatch> tileWatch_;
  std::unique_ptr<TruthProbe> truth_;
  std::unique_ptr<ui::Calibration> calibration_;
  std::unique_ptr<ui::CompassSurvey> survey_;
  std::unique_ptr<ui::RouteTool> routeTool_;
  std::unique_ptr<ui::MeasureTool> measureTool_;
  ui::FindBox* find_ = nullptr;
  ExchangeFiles* exchange_ = nullptr;
  std::unique_ptr<ui::ZoneTool> zoneTool_;
  std::unique_ptr<RegisterDesk> register_;
  std::unique_ptr<RevisionDesk> revisions_;
  std::unique_ptr<BackdropDesk> backdrop_;
  std::unique_ptr<MagneticDesk> magnetic_;
  std::unique_ptr<ui::LayTool> layTool_;
  WindowPanels* panels_;
  ui::StopAllButton* stopAll_;
  ui::StopAllKey* stopAllKey_;
  QPointer<ui::HelpWindow> help_;
  bool commissioning_ = false;  ///< the wizard takes the keys up itself
  bool unasked_ = false;
  bool closesLater_ = false;  ///< by itself, once the compass' values are written
  bool routeBusy_ = false;    ///< as the marks were last put down
  bool open_ = false;         // a site stands in the document
  QLabel* place_;
  QLabel* hint_;
  QToolButton* faults_;
  QLabel* port_;
};

}  // namespace tessera::desktop
