#include "ui/locating/locating_panel.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "floor/bearing.h"
#include "ui/canvas/vehicle_painter.h"

namespace tessera::ui {
namespace {

constexpr int kRefreshEveryMs = 100;
constexpr int kAskAgainMs = 500;
constexpr int kTruthEveryMs = 100;
constexpr double kPerSigma95 = 2.4477;  // half axis of the 95 % ellipse over the standard deviation

QString number(double value, int decimals) { return QLocale{}.toString(value, 'f', decimals); }

}  // namespace

LocatingPanel::LocatingPanel(FleetLink& fleet, Selection& selection, SiteDocument& document, TruthSource& truth,
                             QWidget* parent)
    : QWidget{parent},
      fleet_{fleet},
      selection_{selection},
      document_{document},
      truth_{truth},
      throttle_{kRefreshEveryMs, [this] { refresh(); }} {
  setObjectName(QStringLiteral("locatingPanel"));
  build();
  connect(&fleet_, &FleetLink::snapshotChanged, this, &LocatingPanel::take);
  connect(&selection_, &Selection::vehicleChanged, this, [this] {
    dress();
    asked_.invalidate();
    take();
    refresh();
  });
  connect(&document_, &SiteDocument::changed, this, [this] {
    dress();
    refresh();
  });
  connect(&truth_, &TruthSource::told, this, [this](const TruthSample& sample) { record_.take(sample); });
  truthTimer_.setInterval(kTruthEveryMs);
  connect(&truthTimer_, &QTimer::timeout, this, &LocatingPanel::askTruth);
  retranslate();
  dress();
}

void LocatingPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  asked_.invalidate();
  truthTimer_.start();
  take();
  refresh();
}

// What nobody looks at costs the supervision nothing.
void LocatingPanel::hideEvent(QHideEvent* event) {
  truthTimer_.stop();
  if (fleet_.latest()) fleet_.post(supervisor::Watch{});
  shown_.reset();
  overlay_.show(nullptr, {}, {});
  Q_EMIT overlayChanged();
  QWidget::hideEvent(event);
}

void LocatingPanel::askToWatch() {
  const auto latest = fleet_.latest();
  if (!latest || !selection_.vehicle() || latest->find(*selection_.vehicle()) == nullptr) return;
  if (latest->watched && latest->watched->vehicle == *selection_.vehicle()) return;
  if (asked_.isValid() && asked_.elapsed() < kAskAgainMs) return;
  if (fleet_.post(supervisor::Watch{selection_.vehicle()})) asked_.start();
}

void LocatingPanel::askTruth() {
  if (shown_ && truth_.isThere()) truth_.ask(shown_->watched->vehicle);
}

void LocatingPanel::take() {
  if (!isVisible()) return;
  askToWatch();
  const auto latest = fleet_.latest();
  const bool chosen = latest && latest->watched && latest->watched->vehicle == selection_.vehicle();
  shown_ = chosen ? latest : nullptr;
  if (shown_) {
    record_.take(*shown_);
    const auto* vehicle = shown_->find(shown_->watched->vehicle);
    overlay_.show(shown_->watched, lastReads(*vehicle, shown_->time), shown_->time);
  } else if (!overlay_.empty()) {
    overlay_.show(nullptr, {}, {});
  }
  Q_EMIT overlayChanged();
  throttle_.request();
}

QString LocatingPanel::name() const {
  const auto* setup = selection_.vehicle() ? document_.map()->vehicle(*selection_.vehicle()) : nullptr;
  return setup == nullptr ? QString{} : QString::fromStdString(setup->name);
}

QString LocatingPanel::whatNow() const {
  if (document_.site().vehicles.empty())
    return tr("The site has no vehicle yet. Set one up: Vehicle › Set up a new vehicle.");
  if (!fleet_.latest()) return tr("Connect to the vehicles to see how they are located.");
  if (name().isEmpty()) return tr("Choose a vehicle in the list or on the floor to see how it is located.");
  return tr("Nothing is heard of %1 yet. Its locating shows with its first report.").arg(name());
}

void LocatingPanel::set(Row row, const QString& text) {
  if (values_[row]->text() != text) values_[row]->setText(text);
}

void LocatingPanel::refresh() {
  name_->setText(name());
  pages_->setCurrentIndex(shown_ ? 1 : 0);
  reset_->setEnabled(shown_ != nullptr);
  shape_->setEnabled(shown_ != nullptr);
  if (!shown_) {
    hint_->setText(whatNow());
    return;
  }
  showNumbers(*shown_->watched, *shown_->find(shown_->watched->vehicle), shown_->time);
  showStatistics();
  chart_->show(record_);
}

void LocatingPanel::showNumbers(const supervisor::LocatingView& view, const supervisor::VehicleView& vehicle,
                                Seconds now) {
  const auto pose = [&](const Pose& p) {
    return tr("x %1 m, y %2 m, %3°")
        .arg(number(p.position.x.value(), 3), number(p.position.y.value(), 3), number(degrees(p.heading), 1));
  };
  const QString unknown = tr("not known");
  set(Locator, view.guesses.empty() ? QString::fromStdString(view.locator)
                                    : tr("%1, %n guess(es) shown", nullptr, static_cast<int>(view.guesses.size()))
                                          .arg(QString::fromStdString(view.locator)));
  set(Place, view.located ? pose(view.estimate) : unknown);
  const Ellipse95 ellipse = ellipseOf(view.covariance, 100.0 / kPerSigma95);  // cm, one deviation
  set(Doubt, view.located ? (vehicle.doubted ? tr("A tag speaks for another place.") + QLatin1Char('\n') : QString{}) +
                                tr("%1 cm × %2 cm, %3°")
                                    .arg(number(ellipse.longAxis, 1), number(ellipse.shortAxis, 1),
                                         number(degrees(Radians{std::sqrt(std::max(0.0, view.covariance[8]))}), 1))
                          : unknown);
  set(Report, tr("%1 s ago").arg(number(std::max(0.0, (now - view.at).value()), 2)));
  set(Predicted, view.located ? pose(view.predicted) : unknown);
  set(Delay, tr("%1 s to the next command, which holds %2 s")
                 .arg(number(std::max(0.0, view.delay().value()), 2), number(view.hold.value(), 2)));
  set(Aim, view.aim ? tr("x %1 m, y %2 m: %3 cm ahead")
                          .arg(number(view.aim->x.value(), 2), number(view.aim->y.value(), 2),
                               number(100.0 * distance(*view.aim, view.predicted.position).value(), 0))
                    : tr("nothing: it follows no route"));
  QStringList reads;
  for (const supervisor::ReadView& read : lastReads(vehicle, now))
    reads << tr("reader %1: %2, %3 s ago")
                 .arg(read.reader + 1)
                 .arg(QString::fromStdString(read.uid.text()), number(std::max(0.0, (now - read.at).value()), 1));
  set(Reads, reads.empty() ? tr("none in the last %1 s").arg(number(LocatingOverlay::kOldestRead.value(), 0))
                           : reads.join(QLatin1Char('\n')));
  set(Contradicted, tr("%1 of %2 reads; found anew: %3")
                        .arg(view.counters.rejected)
                        .arg(view.counters.reads)
                        .arg(view.counters.reacquisitions));
}

void LocatingPanel::showStatistics() {
  const LocatingRecord::Verdict verdict = record_.verdict();
  const QString bounds = tr("NIS %1 on average of %2 reads, honest from %3 to %4")
                             .arg(number(verdict.mean, 1), QLocale{}.toString(verdict.count),
                                  number(verdict.bounds.low, 1), number(verdict.bounds.high, 1));
  switch (verdict.is) {
    case LocatingRecord::Verdict::Is::Open:
      set(Fit, verdict.count == 0 ? tr("no reads yet") : tr("too few reads yet: %1").arg(verdict.count));
      break;
    case LocatingRecord::Verdict::Is::Honest:
      set(Fit, tr("as expected. %1").arg(bounds));
      break;
    case LocatingRecord::Verdict::Is::TooSure:
      set(Fit, tr("worse than expected: it is too sure of its place. %1").arg(bounds));
      break;
    case LocatingRecord::Verdict::Is::TooCautious:
      set(Fit, tr("better than expected: it is too cautious. %1").arg(bounds));
      break;
  }
  const LocatingRecord::Errors errors = record_.errors();
  const bool there = truth_.isThere();
  names_[Error]->setVisible(there || errors.count > 0);
  values_[Error]->setVisible(there || errors.count > 0);
  const auto cm = [](Metres m) { return number(100.0 * m.value(), 1); };
  set(Error, errors.count == 0 ? tr("not told yet")
                               : tr("now %1 cm, mean %2 cm, 95 % below %3 cm; NEES %4 (2 is honest), %n sample(s)",
                                    nullptr, static_cast<int>(errors.count))
                                     .arg(cm(errors.now), cm(errors.mean), cm(errors.p95), number(errors.nees, 1)));
}

}  // namespace tessera::ui
