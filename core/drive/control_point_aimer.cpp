#include "drive/control_point_aimer.h"

#include <algorithm>
#include <cmath>

namespace tessera::drive {
namespace {

constexpr Metres kReached{0.05};  // the publication's position error: nearer it cannot know

}  // namespace

ControlPointAimer::ControlPointAimer(const FollowerSetup& setup, std::vector<ControlPoint> points)
    : route_{setup.route.vertices}, points_{std::move(points)}, limits_{setup, route_} {}

Decision ControlPointAimer::decide(const PredictedState& predicted, Seconds now) {
  static_cast<void>(now);
  const VehicleState& state = predicted.state;
  const Point here = state.pose.position;
  Decision decision;
  decision.command = {MetresPerSecond{0.0}, state.pose.heading};
  decision.target = here;
  const bool known = state.located && std::isfinite(here.x.value() + here.y.value() + state.pose.heading.value());
  while (known && next_ < points_.size() && distance(points_[next_].place, here) <= kReached) ++next_;
  decision.phase = known ? Phase::Finished : Phase::Lost;
  if (known && next_ < points_.size()) {
    decision.target = points_[next_].place;
    decision.command.heading = direction(decision.target - here);
    decision.phase = next_ == 0 ? Phase::Approaching : Phase::OnLeg;
  }
  decision.progress = next_ == 0 ? Metres{} : points_[next_ - 1].along;
  if (known && next_ > 0 && next_ < points_.size()) {
    const Polyline::Projection near = route_.project(here, points_[next_ - 1].along, points_[next_].along);
    decision.progress = near.along;
    decision.crossTrack = near.across;
  }
  if (known && next_ < points_.size()) {
    const PlainLimits::Allowed allowed = limits_.at(decision.progress, kReached, predicted);
    decision.command.speed = allowed.limit.speed;
    decision.speedReason = allowed.limit.reason;
    if (allowed.waits) decision.phase = Phase::Waiting;
  }
  decision.remaining = route_.length() - decision.progress;
  decision.leg = route_.legAt(decision.progress);
  decision.headingError = turnBetween(state.pose.heading, decision.command.heading);
  return decision;
}

}  // namespace tessera::drive
