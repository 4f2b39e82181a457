#include "system/supervision.h"

#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QThread>
#include <algorithm>

#include "floor/site_json.h"
#include "system/program.h"

namespace tessera::system_test {

using supervisor::EventKind;

std::shared_ptr<const floor::SiteMap> Supervision::mapOf(const std::string& site) {
  return floor::SiteMap::build(floor::loadSite(site).value()).value();
}

Supervision::Supervision(const std::string& site, const std::string& port) : map_{mapOf(site)} {
  const auto choice = host::PortChoice::parse(QString::fromStdString(port), map_->site().radio.baud).value();
  thread_ = std::make_unique<host::SupervisorThread>(supervisor::Supervisor::create(map_, {}).value(), choice);
  thread_->start();
}

bool Supervision::until(const std::function<bool()>& condition) {
  const QDeadlineTimer end{kPatienceMs};
  while (!end.hasExpired()) {
    QCoreApplication::processEvents();
    for (auto& event : thread_->takeEvents()) events_.push_back(std::move(event));
    if (thread_->latest() && condition()) return true;
    QThread::msleep(5);
  }
  return false;
}

bool Supervision::drive(MetresPerSecond speed, Metres far) {
  if (!until([this] { return connected(); })) return false;
  post(supervisor::RunRoute{view().id, map_->site().routes.front().name, speed});
  return until([this, far] { return view().progress >= far; });
}

supervisor::VehicleView Supervision::view() {
  const auto picture = thread_->latest();
  return picture ? picture->vehicles.front() : supervisor::VehicleView{};
}

bool Supervision::connected() { return view().contact == supervisor::Contact::Connected; }

supervisor::PortState Supervision::port() {
  const auto picture = thread_->latest();
  return picture ? picture->port.state : supervisor::PortState::Closed;
}

int Supervision::told(EventKind kind, bool over) const {
  return static_cast<int>(
      std::count_if(events_.begin(), events_.end(), [&](const auto& e) { return e.kind == kind && e.over == over; }));
}

bool Supervision::hears(EventKind kind, bool over) {
  return until([&] { return told(kind, over) > 0; });
}

std::string Supervision::sentences() const {
  std::string all;
  for (const auto& e : events_) all += std::to_string(e.time.value()) + " s: " + e.sentence.english() + "\n";
  return all;
}

}  // namespace tessera::system_test
