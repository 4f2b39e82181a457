#include "app/tessera/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QScreen>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStatusBar>
#include <QStyle>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <iostream>

#include "app/tessera/backdrop_desk.h"
#include "app/tessera/fleet_session.h"
#include "app/tessera/keeper.h"
#include "app/tessera/magnetic_desk.h"
#include "app/tessera/register_desk.h"
#include "app/tessera/revision_desk.h"
#include "app/tessera/site_files.h"
#include "app/tessera/truth_probe.h"
#include "app/tessera/window_actions.h"
#include "app/tessera/window_panels.h"
#include "ui/calibrate/calibration.h"
#include "ui/calibrate/compass_survey.h"
#include "ui/canvas/floor_canvas.h"
#include "ui/check/fault_watch.h"
#include "ui/connect/start_page.h"
#include "ui/fleet/run_panel.h"
#include "ui/fleet/stop_all.h"
#include "ui/fleet/stop_all_reach.h"
#include "ui/help/help_key.h"
#include "ui/help/help_topic.h"
#include "ui/help/help_window.h"
#include "ui/lay/lay_tool.h"
#include "ui/measure/measure_tool.h"
#include "ui/route/route_tool.h"
#include "ui/tilecheck/tile_watch.h"
#include "ui/zone/zone_tool.h"

namespace tessera::desktop {
namespace {

constexpr QSize kWishedSize{1280, 820};

// A screen may be smaller than what is wished for, or than the one that the window was left on; or that one is gone.
void bringOntoScreen(QWidget& window) {
  if (window.windowState().testAnyFlags(Qt::WindowMaximized | Qt::WindowFullScreen)) return;
  const QScreen* screen = QGuiApplication::screenAt(window.geometry().center());
  const QRect room = (screen != nullptr ? screen : window.screen())->availableGeometry();
  // The frame is there only once the window is shown.
  const int title = window.style()->pixelMetric(QStyle::PM_TitleBarHeight);
  const QRect inside = room.adjusted(0, title, 0, 0);
  window.resize(window.size().boundedTo(inside.size()));
  if (!window.testAttribute(Qt::WA_Moved)) return;  // the desktop gives it a place
  QRect now = window.geometry();
  const QPoint wanted{std::clamp(now.x(), inside.left(), std::max(inside.left(), inside.right() + 1 - now.width())),
                      std::clamp(now.y(), inside.top(), std::max(inside.top(), inside.bottom() + 1 - now.height()))};
  if (wanted == now.topLeft()) return;
  now.moveTo(wanted);
  window.setGeometry(now);  // not move(), which places the frame: the window would wander by it at each start
}

}  // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow{parent} {
  setObjectName(QStringLiteral("mainWindow"));
  session_ = new FleetSession{this};
  files_ = new SiteFiles{document_, settings_, *this};
  files_->setParent(this);
  keeper_ = new Keeper{document_, *session_, this};
  actions_ = new WindowActions{*this, document_.undoStack()};
  buildCentre();
  watch_ = std::make_unique<ui::FaultWatch>(document_);
  panels_ = new WindowPanels{*this, *session_, selection_, document_, *layTool_, *watch_};
  actions_->addOrders(*this, panels_->run->actions());
  // In the menu bar's corner: a tool bar hides what it has no room for.
  menuBar()->setNativeMenuBar(false);
  stopAll_ = new ui::StopAllButton{*session_};
  menuBar()->setCornerWidget(stopAll_, Qt::TopRightCorner);
  stopAllKey_ = new ui::StopAllKey{*session_, this};
  new ui::StopAllReach{*stopAll_, *session_, stopAllKey_};
  connect(new ui::HelpKey{this}, &ui::HelpKey::pressed, this, &MainWindow::showHelp);
  buildStatusBar();
  joinSite();
  joinFleet();
  joinActions();
  joinRegister();
  joinRevisions();
  joinBackdrop();
  joinTileCheck();
  joinLocating();
  joinMagnetic();
  joinCalibration();
  joinPanels();
  joinLooking();
  joinTiles();
  joinZones();
  joinFaults();
  retranslate();
  showSite();
  showFleetState();
}

MainWindow::~MainWindow() {
  session_->close();
  magnetic_.reset();  // it hands what was learned last to the keeper
  register_.reset();  // it asks the keeper
  revisions_.reset();
  backdrop_.reset();
  // Whatever looks at the document goes before it, what is still to be kept first of all.
  delete keeper_;
  document_.disconnect(this);
  selection_.disconnect(this);
  canvas_->setTool(nullptr);
  watch_->disconnect(this);
  routeTool_.reset();
  measureTool_.reset();
  zoneTool_.reset();
  canvas_->setOverlay(nullptr);
  for (QDockWidget* dock : panels_->docks()) {
    dock->disconnect(this);
    delete dock;
  }
  watch_.reset();
  tileWatch_.reset();
  calibration_.reset();
  survey_.reset();
  layTool_.reset();  // its panel looked at it
  delete takeCentralWidget();
  delete files_;
  delete actions_;
  delete stopAllKey_;
  delete session_;
}

void MainWindow::buildCentre() {
  centre_ = new QStackedWidget;
  start_ = new ui::StartPage;
  canvas_ = new ui::FloorCanvas;
  canvas_->setProperty("helpTopic", QStringLiteral("floor"));
  start_->setProperty("helpTopic", QStringLiteral("start"));
  // It scrolls where it has no room: it must not make the window larger than it was left.
  auto* scroll = new QScrollArea;
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setWidget(start_);
  centre_->addWidget(scroll);
  centre_->addWidget(canvas_);
  setCentralWidget(centre_);
  routeTool_ = std::make_unique<ui::RouteTool>(document_, selection_, this);
  zoneTool_ = std::make_unique<ui::ZoneTool>(document_, selection_, this);
  layTool_ = std::make_unique<ui::LayTool>(document_, this);
}

void MainWindow::buildStatusBar() {
  hint_ = new QLabel;
  place_ = new QLabel;
  port_ = new QLabel;
  place_->setObjectName(QStringLiteral("placeLabel"));
  port_->setObjectName(QStringLiteral("portLabel"));
  hint_->setObjectName(QStringLiteral("hintLabel"));
  // It gives way: a long sentence must not make the window wider.
  hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  faults_ = new QToolButton;
  faults_->setObjectName(QStringLiteral("faultSummary"));
  faults_->setAutoRaise(true);
  faults_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  statusBar()->addWidget(hint_, 1);
  statusBar()->addPermanentWidget(faults_);
  statusBar()->addPermanentWidget(place_);
  statusBar()->addPermanentWidget(port_);
}

void MainWindow::restore() {
  setLanguage(settings_.language().isEmpty() ? Languages::ofSystem() : settings_.language());
  setAppearance(settings_.appearance());
  if (!restoreGeometry(settings_.geometry())) resize(kWishedSize);
  bringOntoScreen(*this);
  panels_->setShown(true);
  if (!restoreState(settings_.layout())) panels_->arrangeWhenShown();
  panels_->setShown(open_);
  showRecent();
  keeper_->loadHistory();
}

void MainWindow::reopen() {
  if (files_->openHomeless() || unasked_) return;
  if (!settings_.site().isEmpty() && QFile::exists(settings_.site())) files_->open(settings_.site());
}

void MainWindow::setLanguage(const QString& code) {
  languages_.use(code);
  settings_.setLanguage(languages_.current());
  for (QAction* action : actions_->languages->actions())
    action->setChecked(action->data().toString() == languages_.current());
}

void MainWindow::setAppearance(Appearance appearance) {
  apply(appearance);
  settings_.setAppearance(appearance);
  actions_->appearances->actions().at(static_cast<int>(appearance))->setChecked(true);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!unasked_ && closesWhenWritten()) {
    event->ignore();
    return;
  }
  // The question itself may be ended by an end that does not ask.
  if (!unasked_ && !files_->mayLeave() && !unasked_) {
    event->ignore();
    return;
  }
  panels_->setShown(true);  // the start page hides them; that is no choice to remember
  settings_.setWindow(saveGeometry(), saveState());
  if (open_) settings_.setSite(document_.path());  // else the question about the last one may be open still
  hide();
  const QStringList moving = session_->close();
  magnetic_->keep();
  keeper_->close();
  event->accept();
  if (!moving.isEmpty()) tellUnconfirmed(moving);
}

// An end that does not ask waits for nobody's click either.
void MainWindow::tellUnconfirmed(const QStringList& vehicles) {
  const QString sentence =
      tr("Not confirmed that it stands: %1. A vehicle stops by itself when its last command has run out, a few "
         "seconds later at most. Go and look.")
          .arg(vehicles.join(QStringLiteral(", ")));
  if (unasked_) {
    std::cerr << "tessera: " << sentence.toStdString() << std::endl;
    return;
  }
  QMessageBox box{QMessageBox::Warning, tr("Do all vehicles stand?"), sentence, QMessageBox::Ok};
  box.setObjectName(QStringLiteral("unconfirmedNotice"));
  box.exec();
}

void MainWindow::endUnasked() {
  unasked_ = true;
  while (QWidget* popup = QApplication::activePopupWidget()) popup->hide();
  // Not close(), and not reject(): both may ask.
  while (auto* dialogue = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
    dialogue->done(QDialog::Rejected);
    if (dialogue->isVisible()) break;
  }
  close();
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QMainWindow::changeEvent(event);
}

void MainWindow::retranslate() {
  actions_->retranslate();
  panels_->retranslate();
  Q_EMIT canvas_->hintChanged(canvas_->tool() != nullptr ? canvas_->tool()->hint() : QString{});
  showSite();
  showFleetState();
  // The bar gives its corner another width only when it is asked to; by then the button has its new text.
  QTimer::singleShot(0, this, [this] { menuBar()->setCornerWidget(stopAll_, Qt::TopRightCorner); });
}

void MainWindow::tell(const QString& sentence) { statusBar()->showMessage(sentence, 15000); }

void MainWindow::showHelp() {
  // A modal dialogue lets no other window be used: its help is a window of its own.
  QWidget* modal = QApplication::activeModalWidget();
  if (help_ == nullptr || help_->parentWidget() != (modal != nullptr ? modal : this)) {
    delete help_;
    help_ = new ui::HelpWindow{modal != nullptr ? modal : this};
  }
  // A dialogue that has just come up may not have the focus yet.
  const QWidget* asking = QApplication::focusWidget();
  if (modal != nullptr && (asking == nullptr || !modal->isAncestorOf(asking))) asking = modal;
  help_->showTopic(ui::helpTopicOf(asking));
  help_->show();
  help_->raise();
  help_->activateWindow();
}

}  // namespace tessera::desktop
