// What zones ask of a vehicle: where it is in them, which it needs, and for whom it waits.
#include "supervisor/vehicle_agent.h"

namespace tessera::supervisor {
namespace {

// The body as it is, but for what the estimate may err: less than what is kept free of a zone by those outside it.
constexpr Metres kMayErr{0.02};

}  // namespace

void VehicleAgent::watchZones() {
  if (traffic_->zones.singleCount() == 0) return;
  traffic::RightOfWay& rights = traffic_->rights;
  // A vehicle whose place is not known any more is taken to be where it was.
  if (last_ && estimate_.located && under_ != estimate_.pose) {
    under_ = estimate_.pose;
    rights.standsIn(id(), traffic_->zones.zonesUnder(estimate_.pose, body_.grown(kMayErr)));
  }
  if (task_ == Task::Running || task_ == Task::Paused) {
    const bool waits = task_ == Task::Running && contact_ == Contact::Connected;
    if (guard_) rights.keepOnly(id(), guard_->needed(), waits);
  } else if (stopped() && contact_ == Contact::Connected) {
    rights.keepOnly(id(), {}, false);
  }
}

void VehicleAgent::useTraffic() {
  under_.reset();
  if (guard_) guard_->zonesChanged();
}

Sentence VehicleAgent::zoneWait() const {
  const auto wait = traffic_->rights.waitsFor(id());
  if (!wait) return phrase("Core", "%1 waits: the way ahead has just become free.").with(name_);
  const std::string& zone = traffic_->zones.singleName(wait->zone);
  const auto* setup = map_->vehicle(wait->whom);
  const Sentence other = setup == nullptr ? Sentence{} : vehicleName(*setup);
  using Why = traffic::RightOfWay::Why;
  switch (wait->why) {
    case Why::Inside:
      return phrase("Core", "%1 waits before the single-vehicle zone %2: %3 is in it.").with(name_, zone, other);
    case Why::HasRight:
      return phrase("Core", "%1 waits before the single-vehicle zone %2: %3 drives through it.")
          .with(name_, zone, other);
    case Why::CameFirst:
      return phrase("Core", "%1 waits before the single-vehicle zone %2: %3 came first.").with(name_, zone, other);
    case Why::EachOther:
      return phrase("Core",
                    "%1 waits at the single-vehicle zone %2: it and %3 stand in each other's way. Drive one of them "
                    "out by "
                    "hand.")
          .with(name_, zone, other);
  }
  return {};
}

}  // namespace tessera::supervisor
