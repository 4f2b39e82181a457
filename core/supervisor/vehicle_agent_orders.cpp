// What a vehicle is ordered to do, and why an order cannot be carried out.
#include <algorithm>
#include <cmath>

#include "supervisor/site_change.h"
#include "supervisor/vehicle_agent.h"

namespace tessera::supervisor {

void VehicleAgent::refuse(EventLog& log, const std::string& what) const {
  log.tell(Severity::Warning, EventKind::OrderRefused, id(), name_ + ": " + what);
}

void VehicleAgent::run(const RunRoute& order, EventLog& log) {
  const floor::Route* route = map_->route(order.route);
  if (route == nullptr) return refuse(log, "the site has no route called \"" + order.route + "\".");
  if (!(order.speed > MetresPerSecond{0.0}))
    return refuse(log, "the speed for the route " + order.route + " must be above zero.");
  drive::FollowerSetup setup;
  setup.route = *route;
  setup.ability = ability_;
  setup.plan.requested = std::min(order.speed, ability_.maxSpeed);
  auto follower = drive::makeRouteFollower(controller_, setup);
  if (!follower) return refuse(log, follower.error().sentence);
  follower_ = std::move(*follower);
  routeName_ = order.route;
  decision_.reset();
  wished_.reset();
  hand_.bar(log.now());
  task_ = Task::Running;
  log.tell(Severity::Info, EventKind::RouteStarted, id(),
           name_ + " starts on the route " + routeName_ + " at " + decimal(setup.plan.requested.value(), 2) + " m/s.");
}

void VehicleAgent::pause(EventLog& log) {
  if (task_ != Task::Running) return refuse(log, "it cannot pause, as it runs no route.");
  task_ = Task::Paused;
  log.tell(Severity::Info, EventKind::Paused, id(), name_ + " pauses on the route " + routeName_ + ".");
}

void VehicleAgent::resume(EventLog& log) {
  if (task_ != Task::Paused) return refuse(log, "it cannot go on, as it does not pause.");
  task_ = Task::Running;
  log.tell(Severity::Info, EventKind::Resumed, id(), name_ + " goes on along the route " + routeName_ + ".");
}

void VehicleAgent::stop(EventLog& log) {
  if (task_ == Task::Running || task_ == Task::Paused)
    log.tell(Severity::Info, EventKind::RouteStopped, id(), name_ + " gives up the route " + routeName_ + " by order.");
  hand_.bar(log.now());
  task_ = Task::Stopped;
}

void VehicleAgent::jog(const Jog& order, EventLog& log) {
  const Seconds now = log.now();
  jogRefused_.notSeen(now);
  const auto no = [&](const std::string& why) {
    // The keys repeat themselves; the refusal does not.
    if (jogRefused_.seen(now) == Episode::Change::Begins) refuse(log, why);
  };
  const bool taken = hand_.take(order, now);
  if (!std::isfinite(order.speed.value()) || !std::isfinite(order.turnRate.value())) {
    hand_.bar(now);
    return no("a speed to drive at by hand is no number.");
  }
  if (task_ == Task::Running || task_ == Task::Paused) {
    hand_.bar(now);
    return no("it cannot be driven by hand while it is on the route " + routeName_ + ". Stop it first.");
  }
  if (contact_ != Contact::Connected) {
    hand_.bar(now);
    return no("it cannot be driven by hand, as it is not in touch.");
  }
  if (!taken) return no("it was stopped. Let the keys go before you drive it by hand again.");
  if (task_ != Task::Jogging) {
    follower_.reset();
    routeName_.clear();
    decision_.reset();
    wished_.reset();
  }
  task_ = Task::Jogging;
  if (byHand_.seen(now) == Episode::Change::Begins)
    log.tell(Severity::Info, EventKind::DrivenByHand, id(), name_ + " is driven by hand.");
}

bool VehicleAgent::letGo(EventLog& log) {
  if (task_ == Task::Running || task_ == Task::Paused || task_ == Task::Jogging) {
    refuse(log, "it cannot do that while it drives. Stop it first.");
    return false;
  }
  task_ = Task::None;
  return true;
}

void VehicleAgent::use(std::shared_ptr<const floor::SiteMap> map) {
  const bool same = sameFloor(*map_, *map);
  map_ = std::move(map);
  setup_ = *map_->vehicle(id());
  takeName();
  if (same) return;
  unknownTags_.clear();
  auto made = locate::makeLocator(locatorName_, map_, setup_);
  if (!made) return;  // it was made of the same words and the same vehicle before
  locator_ = std::move(*made);
  locator_->reset(estimate_.located ? std::optional{estimate_.pose} : std::nullopt);
  if (!last_) return;
  motion_->heading = reportedHeading();
  locator_->add(*motion_);
  estimate_ = locator_->at(locator_->lastMotion());
}

}  // namespace tessera::supervisor
