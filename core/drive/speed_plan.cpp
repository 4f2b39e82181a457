#include "drive/speed_plan.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"

namespace tessera::drive {
namespace {

constexpr double kStableShare = 0.25;  // of L/T: damping 0.64, see the decision record on locator and controller
constexpr double kEasyHeading = 0.30;  // rad; a larger error swings the vehicle off the line, so it slows down
constexpr double kStopHeading = 1.00;  // rad; with this much it would drive where it does not want to
constexpr double kLongestDelay = 5.0;  // s

/// A delay that is no number counts as the longest.
double bounded(Seconds delay) { return delay < Seconds{kLongestDelay} ? std::max(delay.value(), 0.01) : kLongestDelay; }

/// Share of the speed left at a doubt from 0 (all) to 1 (none); a doubt that is no number counts as the largest.
double shareLeft(double doubt) { return doubt < 1.0 ? 1.0 - std::max(doubt, 0.0) : 0.0; }

}  // namespace

MetresPerSecond brakingSpeed(Metres way, MetresPerSecond goal, Seconds delay, MetresPerSecond2 braking) {
  const double lost = braking.value() * bounded(delay);
  const double square = goal.value() * goal.value() + 2.0 * braking.value() * std::max(way.value(), 0.0);
  return std::max(goal, MetresPerSecond{std::sqrt(lost * lost + square) - lost});
}

Metres lookAhead(MetresPerSecond speed, Seconds delay, const VehicleAbility& ability, const SpeedPlanOptions& options) {
  const double v = std::abs(speed.value());
  const double stable = v * bounded(delay) / kStableShare;
  const double damped = 2.0 * v * (bounded(delay) + ability.lag.value() + 1.0 / ability.headingGain);
  return std::clamp(Metres{std::max(stable, damped)}, options.shortestLook, options.longestLook);
}

Metres SpeedPlan::stoppingWay(Seconds delay) const {
  const double top = std::min(options_.requested, ability_.maxSpeed).value();
  return Metres{top * bounded(delay) + top * top / (2.0 * braking().value())};
}

SpeedLimit SpeedPlan::at(const Situation& situation) const {
  SpeedLimit limit{std::min(options_.requested, ability_.maxSpeed), SpeedReason::Requested};
  // Before the creep: a leg may be slower than that.
  if (situation.stretch.speed < limit.speed) limit = situation.stretch;
  const MetresPerSecond creep = std::min(options_.creep, limit.speed);
  const auto cut = [&](double speed, SpeedReason reason) {
    const MetresPerSecond allowed = std::max(MetresPerSecond{speed}, creep);
    if (allowed < limit.speed) limit = {allowed, reason};
  };
  const double delay = bounded(situation.delay);
  cut(kStableShare * options_.longestLook.value() / delay, SpeedReason::Delay);
  const double doubt = (situation.sigma - options_.easySigma) / (options_.largestSigma - options_.easySigma);
  cut(limit.speed.value() * shareLeft(doubt), SpeedReason::Uncertainty);
  const double askew =
      (situation.headingSigma - options_.easyHeadingSigma) / (options_.largestHeadingSigma - options_.easyHeadingSigma);
  cut(limit.speed.value() * (options_.leastByHeading + (1.0 - options_.leastByHeading) * shareLeft(askew)),
      SpeedReason::Uncertainty);
  const double off = (std::abs(situation.headingError.value()) - kEasyHeading) / (kStopHeading - kEasyHeading);
  cut(limit.speed.value() * shareLeft(off), SpeedReason::Heading);
  cut(brakingSpeed(situation.toStop, MetresPerSecond{}, situation.delay, braking()).value(),
      situation.stopIsEnd ? SpeedReason::End : SpeedReason::Corner);
  // Where the place is known well there is nothing to be gained by care.
  const Metres approach = std::min(options_.endApproach, options_.endPerSigma * situation.sigma);
  if (situation.stopIsEnd && approach > Metres{})
    cut(brakingSpeed(situation.toStop - approach, options_.endSpeed, situation.delay, braking()).value(),
        SpeedReason::End);
  cut(brakingSpeed(situation.toGate, MetresPerSecond{}, situation.delay, braking()).value(), SpeedReason::Gate);
  return limit;
}

}  // namespace tessera::drive
