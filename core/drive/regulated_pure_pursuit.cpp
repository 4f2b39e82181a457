#include "drive/regulated_pure_pursuit.h"

#include <algorithm>
#include <cmath>

namespace tessera::drive {
namespace {

constexpr Metres kPursuitLook{0.30};
constexpr Metres kPursuitWindow{0.60};       // ahead of the progress, in which the nearest point is looked for
constexpr Metres kPursuitReached{0.02};      // of the end
constexpr Metres kCarrotStep{0.005};         // in which the circle's point on the line is looked for
constexpr double kSlowerRadius = 0.90;       // m: regulated_linear_scaling_min_radius
constexpr double kLeastRegulated = 0.25;     // m/s: regulated_linear_scaling_min_speed
constexpr double kPursuitApproach = 0.60;    // m: approach_velocity_scaling_dist
constexpr double kLeastApproach = 0.05;      // m/s: min_approach_linear_velocity
constexpr double kPursuitTurnFirst = 0.785;  // rad: rotate_to_heading_min_angle
constexpr double kFastestOnTheSpot = 1.8;    // rad/s: rotate_to_heading_angular_vel

}  // namespace

RegulatedPurePursuit::RegulatedPurePursuit(const FollowerSetup& setup)
    : route_{setup.route.vertices}, limits_{setup, route_} {}

Point RegulatedPurePursuit::carrot(Point here) const {
  Metres along = progress_;
  while (along < route_.length() && distance(route_.at(along), here) < kPursuitLook) along += kCarrotStep;
  return route_.at(along);
}

void RegulatedPurePursuit::steer(Decision& decision, const PredictedState& predicted) const {
  const Pose& pose = predicted.state.pose;
  const VehicleAbility& ability = limits_.plan().ability();
  const PlainLimits::Allowed allowed = limits_.at(progress_, kPursuitReached, predicted);
  const double asked = allowed.limit.speed.value();
  decision.target = carrot(pose.position);
  decision.phase = allowed.waits ? Phase::Waiting : Phase::OnLeg;
  decision.speedReason = allowed.limit.reason;
  const Offset ahead = turned(decision.target - pose.position, -pose.heading);
  const double off = direction(ahead).value();
  const double square = std::max(ahead.x.value() * ahead.x.value() + ahead.y.value() * ahead.y.value(), 1e-6);
  const double curvature = 2.0 * ahead.y.value() / square;
  double speed = 0.0;
  double rate = std::clamp(ability.headingGain * off, -kFastestOnTheSpot, kFastestOnTheSpot);
  if (allowed.waits) {
    rate = 0.0;
  } else if (std::abs(off) < kPursuitTurnFirst) {
    const double radius = 1.0 / std::max(std::abs(curvature), 1e-6);
    speed = radius < kSlowerRadius ? std::max(asked * radius / kSlowerRadius, std::min(kLeastRegulated, asked)) : asked;
    const double left = (route_.length() - progress_).value();
    if (left < kPursuitApproach)
      speed = std::min(speed, std::max(asked * left / kPursuitApproach, std::min(kLeastApproach, asked)));
    rate = speed * curvature;
  }
  rate = std::clamp(rate, -ability.maxTurnRate.value(), ability.maxTurnRate.value());
  decision.command.speed = MetresPerSecond{speed};
  decision.command.heading = headingToTurn(RadiansPerSecond{rate}, pose.heading, predicted.delay, ability);
}

Decision RegulatedPurePursuit::decide(const PredictedState& predicted, Seconds now) {
  static_cast<void>(now);
  const VehicleState& state = predicted.state;
  const Point here = state.pose.position;
  Decision decision;
  decision.command = {MetresPerSecond{0.0}, state.pose.heading};
  decision.target = here;
  const bool known = state.located && std::isfinite(here.x.value() + here.y.value() + state.pose.heading.value());
  if (known && !finished_) {
    const auto near = route_.project(here, progress_, progress_ + kPursuitWindow);
    progress_ = near.along;
    decision.crossTrack = near.across;
    finished_ = route_.length() - progress_ <= kPursuitReached;
    if (!finished_) steer(decision, predicted);
  }
  if (finished_) decision.phase = Phase::Finished;
  decision.progress = progress_;
  decision.remaining = route_.length() - progress_;
  decision.leg = route_.legAt(progress_);
  decision.headingError = turnBetween(state.pose.heading, decision.command.heading);
  return decision;
}

}  // namespace tessera::drive
