#include "ui/check/fault_watch.h"

#include <utility>

namespace tessera::ui {

FaultWatch::FaultWatch(SiteDocument& document, QObject* parent)
    : QObject{parent}, document_{document}, thread_{[this] {
        QMetaObject::invokeMethod(this, &FaultWatch::take, Qt::QueuedConnection);
      }} {
  connect(&document_, &SiteDocument::replaced, this, [this] {
    verdict_ = {};
    checked_.reset();
    another_ = true;
  });
  connect(&document_, &SiteDocument::changed, this, [this] {
    order();
    Q_EMIT changed();
  });
  order();
}

void FaultWatch::order() {
  wanted_.site = sitecheck::siteOf(document_.map());
  thread_.check(wanted_);
}

void FaultWatch::setClearance(Metres clearance) {
  if (clearance == wanted_.options.clearance) return;
  wanted_.options.clearance = clearance;
  order();
  Q_EMIT changed();
}

void FaultWatch::tryRoute(std::optional<floor::Route> route) {
  if (route == wanted_.trial) return;
  wanted_.trial = std::move(route);
  if (wanted_.trial) {
    thread_.check(wanted_);
  } else {
    Q_EMIT routeTried({});
  }
}

void FaultWatch::take() {
  const auto result = thread_.take();
  if (result == nullptr || (another_ && result->order.site != wanted_.site)) return;
  another_ = false;
  // A later order may have changed only the route that is tried: the verdict holds all the same.
  const bool news = result->order.site != checked_ || result->order.options != options_;
  checked_ = result->order.site;
  options_ = result->order.options;
  verdict_ = result->verdict;
  if (news) Q_EMIT changed();
  if (wanted_.trial && result->order.trial == wanted_.trial) Q_EMIT routeTried(result->trialFaults);
}

}  // namespace tessera::ui
