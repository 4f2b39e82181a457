// The chosen vehicle: how it stands and why, its route and speed, and the orders that make sense now.
#pragma once

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHash>
#include <QLabel>
#include <QProgressBar>
#include <QStackedLayout>
#include <QToolButton>

#include "ui/base/fleet_link.h"
#include "ui/base/notice.h"
#include "ui/base/selection.h"
#include "ui/base/site_document.h"
#include "ui/base/throttle.h"
#include "ui/fleet/condition.h"
#include "ui/fleet/hint.h"
#include "ui/fleet/order_rules.h"
#include "ui/fleet/time_left.h"

namespace tessera::ui {

class RunPanel : public QWidget {
  Q_OBJECT
public:
  RunPanel(FleetLink& link, Selection& selection, SiteDocument& document, QWidget* parent = nullptr);

  /// For menus and tool bars: with texts, icons, shortcuts, and enabled as the buttons are. The panel owns them.
  [[nodiscard]] QAction* runAction() const { return run_; }
  [[nodiscard]] QAction* pauseAction() const { return pause_; }  ///< Pause or Resume, whichever there is to do
  [[nodiscard]] QAction* stopAction() const { return stop_; }
  [[nodiscard]] QAction* clearAction() const { return clear_; }

Q_SIGNALS:
  /// The site has no route, and the operator wants one.
  void drawRouteRequested();
  void commissionRequested();

protected:
  void changeEvent(QEvent* event) override;

private:
  struct Ordered {
    QString route;
    double speed = 0.0;
  };

  void build();
  QWidget* buildVehicle();
  [[nodiscard]] QAction* makeAction(const QString& name, const QKeySequence& key, void (RunPanel::*order)());
  void retranslate();
  void takeSite();
  void takeVehicle();
  void followRoute();
  void refresh();
  void showState(const supervisor::Snapshot* snapshot, const supervisor::VehicleView* view);
  void dress();
  /// The button that pauses and resumes is as wide as either word needs.
  void holdPauseWidth();
  void showProgress(const supervisor::VehicleView* view);
  void showActions(const OrderCase& c);
  void setUp(QAction* action, const QString& does, const QString& whyNot);
  void takeEvents(const std::vector<supervisor::Event>& events);
  void post(const supervisor::Order& order);
  void run();
  void pauseOrResume();
  void stop();
  void clear();
  [[nodiscard]] const floor::VehicleSetup* setup() const;
  [[nodiscard]] QString name() const;
  [[nodiscard]] OrderCase orderCase(const supervisor::Snapshot* snapshot) const;

  FleetLink& link_;
  Selection& selection_;
  SiteDocument& document_;
  QAction* run_ = nullptr;
  QAction* pause_ = nullptr;
  QAction* stop_ = nullptr;
  QAction* clear_ = nullptr;
  QStackedLayout* pages_ = nullptr;
  FleetHint* nobody_ = nullptr;
  QLabel* dot_ = nullptr;
  QLabel* name_ = nullptr;
  QLabel* stateIcon_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* sentence_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* remaining_ = nullptr;
  QLabel* routeLabel_ = nullptr;
  QComboBox* route_ = nullptr;
  QToolButton* drawRoute_ = nullptr;
  QLabel* speedLabel_ = nullptr;
  QDoubleSpinBox* speed_ = nullptr;
  Notice* notice_ = nullptr;
  Throttle throttle_;
  QHash<int, double> speeds_;    ///< m/s, by vehicle: what was set last
  QHash<int, Ordered> ordered_;  ///< by vehicle: what this panel ordered last
  double smoothSpeed_ = 0.0;     ///< m/s, for the time that is left
  TimeLeft timeLeft_;
  std::optional<Condition> shown_;  ///< the state that icon and colour tell now
  bool filling_ = false;
};

}  // namespace tessera::ui
