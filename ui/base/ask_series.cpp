#include "ui/base/ask_series.h"

#include <chrono>
#include <utility>

#include "ui/base/wording.h"

namespace tessera::ui {
namespace {

// The link itself tells of a missing answer much sooner; this is for a supervision that has ended meanwhile.
constexpr auto kAskPatience = std::chrono::seconds{20};

}  // namespace

AskSeries::AskSeries(FleetLink& link, QObject* parent) : QObject{parent}, link_{link} {
  patience_.setSingleShot(true);
  patience_.setInterval(kAskPatience);
  connect(&patience_, &QTimer::timeout, this, [this] { fail(tr("No answer came. Check the connection.")); });
  connect(&link_, &FleetLink::eventsArrived, this, &AskSeries::hear);
}

void AskSeries::start(VehicleId vehicle, std::vector<wire::Request> requests) {
  vehicle_ = vehicle;
  requests_ = std::move(requests);
  at_ = 0;
  ask();
}

void AskSeries::stop() {
  at_ = requests_.size();
  patience_.stop();
}

void AskSeries::ask() {
  if (!isRunning()) {
    patience_.stop();
    Q_EMIT finished();
    return;
  }
  patience_.start();
  if (!link_.post(supervisor::Ask{vehicle_, requests_[at_]}))
    fail(tr("Not connected. Connect to the vehicles and try again."));
}

void AskSeries::hear(const std::vector<supervisor::Event>& events) {
  for (const supervisor::Event& event : events) {
    if (!isRunning() || event.vehicle != vehicle_) continue;
    if (event.kind == supervisor::EventKind::OrderRefused) {
      fail(text(event.sentence));
    } else if (event.kind == supervisor::EventKind::Answer && event.answer && event.answer->request == requests_[at_]) {
      if (!event.answer->value) {
        fail(text(event.sentence));
        continue;
      }
      const std::size_t index = at_++;
      Q_EMIT answered(index, *event.answer);
      if (index + 1 == at_) ask();  // nobody has begun another series meanwhile
    }
  }
}

void AskSeries::fail(const QString& sentence) {
  stop();
  Q_EMIT failed(sentence);
}

}  // namespace tessera::ui
