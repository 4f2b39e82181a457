// What a vehicle is ordered to do, and why an order cannot be carried out.
#include <algorithm>
#include <cmath>

#include "drive/driven_way.h"
#include "supervisor/site_change.h"
#include "supervisor/vehicle_agent.h"

namespace tessera::supervisor {

void VehicleAgent::refuse(EventLog& log, const Sentence& why) const {
  log.tell(Severity::Warning, EventKind::OrderRefused, id(), why);
}

void VehicleAgent::run(const RunRoute& order, EventLog& log) {
  const floor::Route* route = map_->route(order.route);
  if (route == nullptr)
    return refuse(log, phrase("Core", "%1: the site has no route called \"%2\".").with(name_, order.route));
  if (!(order.speed > MetresPerSecond{0.0}))
    return refuse(log, phrase("Core", "%1: the speed for the route %2 must be above zero.").with(name_, order.route));
  if (Polyline{route->vertices}.legCount() == 0)
    return refuse(log,
                  phrase("Core", "%1: the route %2 needs at least two different points.").with(name_, order.route));
  // The way that it takes round a corner may lead through a zone that the line drawn passes by.
  const Polyline drawn{route->vertices};
  for (const Polyline& way :
       {drawn, drive::roundsCorners(controller_) ? drive::drivenWay(*route, ability_).line() : drawn})
    if (const auto wrong = traffic_->zones.wrongWay(way))
      return refuse(log, phrase("Core", "%1: the route %2 leads %3 m the wrong way through the one-way zone %4.")
                             .with(name_, order.route, decimal(wrong->length.value(), 2), wrong->zone));
  drive::FollowerSetup setup;
  const auto guard = std::make_shared<traffic::ZoneGuard>(id(), body_, traffic_);
  setup.guard = guard;
  setup.route = *route;
  setup.ability = ability_;
  setup.plan.requested = std::min(order.speed, ability_.maxSpeed);
  auto follower = drive::makeRouteFollower(controller_, setup);
  if (!follower) return refuse(log, Pattern{"", "%1: %2"}.with(name_, follower.error().sentence));
  follower_ = std::move(*follower);
  guard_ = guard;
  routeName_ = order.route;
  decision_.reset();
  wished_.reset();
  hand_.bar(log.now());
  task_ = Task::Running;
  log.tell(Severity::Info, EventKind::RouteStarted, id(),
           phrase("Core", "%1 starts on the route %2 at %3 m/s.")
               .with(name_, routeName_, decimal(setup.plan.requested.value(), 2)));
}

void VehicleAgent::pause(EventLog& log) {
  if (task_ != Task::Running)
    return refuse(log, phrase("Core", "%1: it cannot pause, as it runs no route.").with(name_));
  task_ = Task::Paused;
  log.tell(Severity::Info, EventKind::Paused, id(),
           phrase("Core", "%1 pauses on the route %2.").with(name_, routeName_));
}

void VehicleAgent::resume(EventLog& log) {
  if (task_ != Task::Paused)
    return refuse(log, phrase("Core", "%1: it cannot go on, as it does not pause.").with(name_));
  task_ = Task::Running;
  log.tell(Severity::Info, EventKind::Resumed, id(),
           phrase("Core", "%1 goes on along the route %2.").with(name_, routeName_));
}

void VehicleAgent::stop(EventLog& log) {
  if (task_ == Task::Running || task_ == Task::Paused)
    log.tell(Severity::Info, EventKind::RouteStopped, id(),
             phrase("Core", "%1 gives up the route %2 by order.").with(name_, routeName_));
  hand_.bar(log.now());
  task_ = Task::Stopped;
}

void VehicleAgent::jog(const Jog& order, EventLog& log) {
  const Seconds now = log.now();
  jogRefused_.notSeen(now);
  const auto no = [&](const Sentence& why) {
    // The keys repeat themselves; the refusal does not.
    if (jogRefused_.seen(now) == Episode::Change::Begins) refuse(log, why);
  };
  const bool taken = hand_.take(order, now);
  if (!std::isfinite(order.speed.value()) || !std::isfinite(order.turnRate.value())) {
    hand_.bar(now);
    return no(phrase("Core", "%1: a speed to drive at by hand is no number.").with(name_));
  }
  if (task_ == Task::Running || task_ == Task::Paused) {
    hand_.bar(now);
    return no(phrase("Core", "%1: it cannot be driven by hand while it is on the route %2. Stop it first.")
                  .with(name_, routeName_));
  }
  if (contact_ != Contact::Connected) {
    hand_.bar(now);
    return no(phrase("Core", "%1: it cannot be driven by hand, as it is not in touch.").with(name_));
  }
  if (!taken)
    return no(phrase("Core", "%1: it was stopped. Let the keys go before you drive it by hand again.").with(name_));
  if (task_ != Task::Jogging) {
    follower_.reset();
    guard_.reset();
    routeName_.clear();
    decision_.reset();
    wished_.reset();
  }
  task_ = Task::Jogging;
  if (byHand_.seen(now) == Episode::Change::Begins)
    log.tell(Severity::Info, EventKind::DrivenByHand, id(), phrase("Core", "%1 is driven by hand.").with(name_));
}

bool VehicleAgent::letGo(EventLog& log) {
  if (task_ == Task::Running || task_ == Task::Paused || task_ == Task::Jogging) {
    refuse(log, phrase("Core", "%1: it cannot do that while it drives. Stop it first.").with(name_));
    return false;
  }
  task_ = Task::None;
  return true;
}

void VehicleAgent::use(std::shared_ptr<const floor::SiteMap> map) {
  const bool sameNorth = map_->site().northToY == map->site().northToY;
  map_ = std::move(map);
  setup_ = *map_->vehicle(id());
  takeName();
  std::erase_if(unknownTags_, [&](const floor::TagUid& uid) { return map_->find(uid).has_value(); });
  if (sameNorth) return locator_->useMap(map_);
  learner_.restart();
  auto made = locate::makeLocator(locatorName_, map_, setup_);
  if (!made) return;  // it was made of the same words and the same vehicle before
  locator_ = std::move(*made);
  locator_->reset(estimate_.located ? std::optional{estimate_.pose} : std::nullopt);
  if (!last_) return;
  motion_->heading = reportedHeading();
  locator_->add(*motion_);
  estimate_ = locator_->at(locator_->lastMotion());
}

bool VehicleAgent::mayBePaired(EventLog& log) const {
  if (contact_ != Contact::Connected) {
    refuse(log, phrase("Core", "%1 can be given another key only while it is connected.").with(name_));
    return false;
  }
  if (task_ == Task::Running || task_ == Task::Jogging) {
    refuse(log, phrase("Core", "%1 drives; stop it before you give it another key.").with(name_));
    return false;
  }
  return true;
}

}  // namespace tessera::supervisor
