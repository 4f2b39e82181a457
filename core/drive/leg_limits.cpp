#include "drive/leg_limits.h"

#include <algorithm>

#include "base/polyline.h"
#include "floor/route_legs.h"

namespace tessera::drive {
namespace {

constexpr Metres kBefore{0.02};  // of a slower leg, in which the last of the braking dies away

}  // namespace

LegLimits::LegLimits(const floor::Route& route) {
  const Polyline line{route.vertices};
  const auto speeds = floor::legSpeedsOfLine(route);
  for (std::size_t leg = 0; leg < line.legCount(); ++leg)
    if (speeds[leg]) stretches_.push_back({line.startOf(leg), line.startOf(leg + 1), *speeds[leg]});
}

SpeedLimit LegLimits::at(Metres along, Metres doubt, Seconds delay, const SpeedPlan& plan, Metres from) const {
  SpeedLimit limit{MetresPerSecond{std::numeric_limits<double>::infinity()}, SpeedReason::Leg};
  const double top = std::min(plan.options().requested, plan.ability().maxSpeed).value();
  const Metres behind = std::max(along - doubt, from);
  const auto first = std::partition_point(stretches_.begin(), stretches_.end(),
                                          [&](const Stretch& stretch) { return stretch.to <= behind; });
  for (auto at = first; at != stretches_.end(); ++at) {
    const Metres way = std::max(at->from, from) - (along + doubt + kBefore);
    if (brakingSpeed(way, {}, delay, plan.braking()).value() > top) break;  // as is every later one
    const bool here = way <= Metres{};
    const MetresPerSecond speed = here ? at->speed : brakingSpeed(way, at->speed, delay, plan.braking());
    if (speed < limit.speed) limit = {speed, here ? SpeedReason::Leg : SpeedReason::SlowerLeg};
  }
  return limit;
}

}  // namespace tessera::drive
