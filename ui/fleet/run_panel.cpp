#include "ui/fleet/run_panel.h"

#include <QEvent>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/base/icon.h"
#include "ui/base/wording.h"

namespace tessera::ui {
namespace {

constexpr double kUsualSpeed = 0.3;  // m/s, as in the publication
constexpr double kSpeedStep = 0.05;

}  // namespace

RunPanel::RunPanel(FleetLink& link, Selection& selection, SiteDocument& document, QWidget* parent)
    : QWidget{parent}, link_{link}, selection_{selection}, document_{document}, throttle_{100, [this] { refresh(); }} {
  setObjectName(QStringLiteral("runPanel"));
  build();
  connect(&link_, &FleetLink::snapshotChanged, this, [this] { throttle_.request(); });
  connect(&link_, &FleetLink::eventsArrived, this, &RunPanel::takeEvents);
  connect(&selection_, &Selection::vehicleChanged, this, &RunPanel::takeVehicle);
  connect(&selection_, &Selection::routeChanged, this, &RunPanel::followRoute);
  connect(&document_, &SiteDocument::changed, this, &RunPanel::takeSite);
  connect(&document_, &SiteDocument::replaced, this, [this] {
    speeds_.clear();
    ordered_.clear();
  });
  retranslate();
  takeSite();
  takeVehicle();
}

const floor::VehicleSetup* RunPanel::setup() const {
  return selection_.vehicle() ? document_.map()->vehicle(*selection_.vehicle()) : nullptr;
}

QString RunPanel::name() const { return setup() == nullptr ? QString{} : QString::fromStdString(setup()->name); }

OrderCase RunPanel::orderCase(const supervisor::Snapshot* snapshot) const {
  OrderCase c;
  c.snapshot = snapshot;
  if (setup() != nullptr) c.vehicle = selection_.vehicle();
  c.name = name();
  c.route = selection_.route();
  c.siteHasRoutes = !document_.site().routes.empty();
  const auto* view = snapshot == nullptr || !c.vehicle ? nullptr : snapshot->find(*c.vehicle);
  if (view != nullptr && view->task == supervisor::Task::Running) {
    const auto before = ordered_.value(view->id.value, {QString::fromStdString(view->route), speed_->value()});
    c.sameAsRunning = QString::fromStdString(view->route) == c.route && before.route == c.route &&
                      std::abs(before.speed - speed_->value()) < 1e-6;
  }
  return c;
}

// A name that was chosen stays chosen while the site has it; the only route there is needs no choosing.
void RunPanel::takeSite() {
  QStringList names;
  for (const auto& route : document_.site().routes) names.append(QString::fromStdString(route.name));
  QStringList listed;
  for (int i = 0; i < route_->count(); ++i) listed.append(route_->itemText(i));
  if (names != listed) {
    filling_ = true;
    route_->clear();
    route_->addItems(names);
    filling_ = false;
  }
  if (!names.contains(selection_.route())) selection_.setRoute(names.size() == 1 ? names.front() : QString{});
  followRoute();
  takeVehicle();
}

void RunPanel::followRoute() {
  filling_ = true;
  route_->setCurrentIndex(route_->findText(selection_.route(), Qt::MatchExactly | Qt::MatchCaseSensitive));
  filling_ = false;
  refresh();
}

void RunPanel::takeVehicle() {
  const floor::VehicleSetup* vehicle = setup();
  smoothSpeed_ = 0.0;
  timeLeft_.reset();
  notice_->clear();
  pages_->setCurrentIndex(vehicle == nullptr ? 1 : 0);
  if (vehicle != nullptr) {
    const double most = std::max(kSpeedStep, std::floor(vehicle->maxSpeed.value() * 100.0 + 1e-6) / 100.0);
    filling_ = true;
    speed_->setRange(kSpeedStep, most);
    speed_->setValue(std::min(speeds_.value(vehicle->id.value, kUsualSpeed), most));
    filling_ = false;
  }
  retranslate();
}

void RunPanel::refresh() {
  const auto snapshot = link_.latest();
  const auto* vehicle = setup();
  const auto* view = snapshot && vehicle != nullptr ? snapshot->find(vehicle->id) : nullptr;
  if (vehicle != nullptr) {
    showState(snapshot.get(), view);
    showProgress(view);
  }
  drawRoute_->setVisible(document_.site().routes.empty());
  showActions(orderCase(snapshot.get()));
}

void RunPanel::showProgress(const supervisor::VehicleView* view) {
  using supervisor::Task;
  const bool underWay = view != nullptr && !view->route.empty() && view->length > Metres{} && view->task != Task::None;
  progress_->setVisible(underWay);
  remaining_->setVisible(underWay);
  if (!underWay) return timeLeft_.reset();
  const double length = view->length.value();
  const double done = std::clamp(view->progress.value(), 0.0, length);
  progress_->setValue(static_cast<int>(std::lround(1000.0 * done / length)));
  const double speed = std::abs(view->speed.value());
  smoothSpeed_ += (smoothSpeed_ > 0.0 ? 0.05 : 1.0) * (speed - smoothSpeed_);
  const QLocale locale;
  const QString travelled =
      tr("%1 of %2 m on the route %3")
          .arg(locale.toString(done, 'f', 1), locale.toString(length, 'f', 1), QString::fromStdString(view->route));
  const double pace = std::max(smoothSpeed_, 0.5 * speed);
  if (view->task != Task::Running || pace < 0.02) return remaining_->setText(travelled);
  const int left = timeLeft_.shown((length - done) / pace);
  const QString time = left < 60 ? tr("%1 s").arg(left) : tr("%1 min %2 s").arg(left / 60).arg(left % 60);
  remaining_->setText(tr("%1, about %2 left", "distance travelled, time").arg(travelled, time));
}

void RunPanel::setUp(QAction* action, const QString& does, const QString& whyNot) {
  action->setEnabled(whyNot.isEmpty());
  const QString key = action->shortcut().toString(QKeySequence::NativeText);
  const QString tip = whyNot.isEmpty() ? does : whyNot;
  action->setToolTip(key.isEmpty() ? tip : tr("%1 (%2)", "what a button does, its key").arg(tip, key));
}

void RunPanel::showActions(const OrderCase& c) {
  const auto* view = c.snapshot == nullptr || !c.vehicle ? nullptr : c.snapshot->find(*c.vehicle);
  const bool paused = view != nullptr && view->task == supervisor::Task::Paused;
  pause_->setText(paused ? tr("R&esume") : tr("&Pause"));
  pause_->setIcon(icon(paused ? QStringLiteral("resume") : QStringLiteral("pause")));
  setUp(run_, tr("Let it drive along the chosen route, at most this fast."), whyNotRun(c));
  setUp(pause_, paused ? tr("Let it go on along its route.") : tr("Let it stand and keep its route."),
        paused ? whyNotResume(c) : whyNotPause(c));
  setUp(stop_, tr("Stop it; it gives up its route."), whyNotStop(c));
  setUp(clear_, tr("Forget faults whose cause is gone."), whyNotClear(c));
}

void RunPanel::takeEvents(const std::vector<supervisor::Event>& events) {
  for (const auto& event : events) {
    if (event.kind != supervisor::EventKind::OrderRefused || event.vehicle != selection_.vehicle()) continue;
    notice_->show(Notice::Tone::Warning, text(event.sentence));
  }
}

void RunPanel::post(const supervisor::Order& order) {
  const bool taken = link_.post(order);
  notice_->clear();
  if (!taken)
    notice_->show(Notice::Tone::Error, tr("The order was not taken: there is no connection to the vehicles."));
  refresh();
}

// The picture may be older than the action's last look: what is ordered is judged by the newest.
void RunPanel::run() {
  const auto snapshot = link_.latest();
  if (!whyNotRun(orderCase(snapshot.get())).isEmpty()) return refresh();
  speed_->interpretText();
  ordered_[selection_.vehicle()->value] = {selection_.route(), speed_->value()};
  post(supervisor::RunRoute{*selection_.vehicle(), selection_.route().toStdString(), MetresPerSecond{speed_->value()}});
}

void RunPanel::pauseOrResume() {
  const auto snapshot = link_.latest();
  const OrderCase c = orderCase(snapshot.get());
  if (whyNotPause(c).isEmpty()) return post(supervisor::Pause{*c.vehicle});
  if (whyNotResume(c).isEmpty()) return post(supervisor::Resume{*c.vehicle});
  refresh();
}

void RunPanel::stop() {
  if (setup() != nullptr) post(supervisor::Stop{setup()->id});
}

void RunPanel::clear() {
  if (setup() != nullptr) post(supervisor::Clear{setup()->id});
}

}  // namespace tessera::ui
