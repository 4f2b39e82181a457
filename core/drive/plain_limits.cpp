#include "drive/plain_limits.h"

#include <algorithm>

namespace tessera::drive {

PlainLimits::PlainLimits(const FollowerSetup& setup, const Polyline& way)
    : plan_{setup.ability, setup.plan}, legs_{StretchLimits::ofLegs(setup.route)}, guard_{setup.guard} {
  if (guard_) guard_->laid(way);
}

PlainLimits::Allowed PlainLimits::at(Metres along, Metres late, const PredictedState& predicted) const {
  const Seconds delay = predicted.delay + plan_.ability().lag;
  const Metres doubt = late + 2.0 * predicted.state.sigma;
  Allowed allowed{{std::min(plan_.options().requested, plan_.ability().maxSpeed), SpeedReason::Requested}, false};
  allowed.limit = stricter(allowed.limit, legs_.at(along, doubt, delay, plan_));
  if (!guard_) return allowed;
  allowed.limit = stricter(allowed.limit, guard_->limits().at(along, doubt, delay, plan_));
  const Metres left = guard_->mayGoTo(along, plan_.stoppingWay(delay)) - along - late;
  allowed.waits = left <= Metres{};
  allowed.limit = stricter(allowed.limit, {brakingSpeed(left, {}, delay, plan_.braking()), SpeedReason::Gate});
  return allowed;
}

}  // namespace tessera::drive
