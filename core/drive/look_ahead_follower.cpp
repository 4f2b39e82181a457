#include "drive/look_ahead_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tessera::drive {
namespace {

constexpr Metres kOnRoute{0.03};     // a vehicle this near to the start needs no way to it
constexpr Metres kOffRoute{0.40};    // farther away it was carried, and is led back by a way of its own
constexpr Metres kWindow{0.50};      // ahead of the progress, in which the nearest point is looked for
constexpr Radians kBeside{1.6};      // what turns by more is not ahead, but comes back
constexpr Metres kBendWindow{0.06};  // over which a curve is taken to be even
constexpr double kSurely = 2.0;      // standard deviations of the place within which a leg's speed holds
constexpr Metres kAtEnd{0.002};      // short of the end: no more worth moving for
constexpr MetresPerSecond kInching{0.01};
constexpr int kMostInches = 3;
constexpr Seconds kShortestHold{0.05};
constexpr Seconds kLongestHold{2.0};
constexpr Radians kAligned{0.087};    // 5°: turning on the spot ends
constexpr Radians kMisaligned{1.05};  // 60°: it stops and turns on the spot in the middle of a leg, too

}  // namespace

LookAheadFollower::LookAheadFollower(const FollowerSetup& setup)
    : plan_{setup.ability, setup.plan},
      way_{drivenWay(setup.route, setup.ability, setup.plan)},
      legs_{StretchLimits::ofLegs(setup.route, way_)},
      guard_{setup.guard} {}

void LookAheadFollower::layPath(Point from) {
  const Metres reached = laid_ ? std::max(Metres{}, progress_ - approach_) + skipped_ : Metres{};
  const Polyline& way = way_.line();
  const Point join = way.at(reached);
  std::vector<Point> vertices;
  const bool away = distance(from, join) > kOnRoute;
  if (away) vertices.push_back(from);
  vertices.push_back(join);
  for (std::size_t v = way.legAt(reached) + 1; v < way.vertices().size(); ++v) vertices.push_back(way.vertices()[v]);
  path_ = Polyline{vertices};
  approach_ = away ? distance(from, join) : Metres{};
  skipped_ = reached;
  progress_ = Metres{};
  laid_ = true;
  turning_ = true;
  stoodSince_.reset();
  inching_ = false;
  if (guard_) guard_->laid(path_);
  const VehicleAbility& ability = plan_.ability();
  bends_ = bendLimits(path_, turnRateAtFullSpeed(ability), plan_.options().sharpCorner,
                      arcStretches(way_, turnRateOnArcs(ability), approach_ - skipped_));
  findStop();
}

void LookAheadFollower::findStop() {
  begin_ = path_.legAt(progress_);
  stop_ = path_.legAt(progress_) + 1;
  while (stop_ < path_.legCount() && !plan_.isSharp(turnBetween(path_.headingOf(stop_ - 1), path_.headingOf(stop_))))
    ++stop_;
}

Polyline::Projection LookAheadFollower::nearest(Point here) const {
  Metres to = std::min(progress_ + kWindow, path_.startOf(stop_));
  // A rounded corner may lead back beside the way to it, without a stop in between.
  if (!way_.arcs().empty()) {
    const std::size_t leg = path_.legAt(progress_);
    for (std::size_t v = leg + 1; v < stop_ && path_.startOf(v) < to; ++v)
      if (abs(turnBetween(path_.headingOf(leg), path_.headingOf(v))) > kBeside) to = path_.startOf(v);
  }
  return path_.project(here, progress_, to);
}

Point LookAheadFollower::aim(Metres look) const {
  const Metres ahead = progress_ + look;
  const Metres stop = path_.startOf(stop_);
  if (ahead <= stop) return path_.at(ahead);
  // Beyond a stop the last leg is thought on, so that the aim keeps its distance and never falls behind the nose.
  return path_.at(stop) + (ahead - stop).value() * turned({Metres{1.0}, Metres{}}, path_.headingOf(stop_ - 1));
}

void LookAheadFollower::report(Decision& decision, const VehicleState& state) const {
  const Metres along = way_.onDrawn(std::max(Metres{}, progress_ - approach_) + skipped_);
  decision.progress = std::min(route().length(), along);
  decision.remaining = route().length() - decision.progress;
  decision.crossTrack = across_;
  decision.leg = route().legAt(decision.progress);
  decision.headingError = turnBetween(state.pose.heading, decision.command.heading);
}

Decision LookAheadFollower::stand(Phase phase, Radians heading, const VehicleState& state) const {
  Decision decision;
  decision.command = {MetresPerSecond{0.0}, heading};
  decision.phase = phase;
  decision.target = state.pose.position;
  report(decision, state);
  return decision;
}

// The curve's own turn rate, as the wheels will have it when they obey, and what brings the nose to the course.
Radians LookAheadFollower::holdOnCurve(const PredictedState& predicted, Radians course) const {
  const VehicleState& state = predicted.state;
  const VehicleAbility& ability = plan_.ability();
  const double speed = std::max(state.speed, plan_.options().creep).value();
  const double delay = std::isfinite(predicted.delay.value()) ? predicted.delay.value() : 0.0;
  const Metres late{speed * (ability.lag.value() + 0.5 * delay)};
  const double error = turnBetween(state.pose.heading, course).value();
  const double most = ability.maxTurnRate.value();
  const double bend = std::clamp(speed * curve().curvature(progress_ + late), -most, most);
  // What is missing to the course is told as it is: the vehicle makes it good within a command. Told as a rate, which
  // has to make up for half of the command's time as well, it would be overshot the more, the longer a command holds.
  const double missing = std::clamp(error, -most / ability.headingGain, most / ability.headingGain);
  return wrapped(headingToTurn(RadiansPerSecond{bend}, state.pose.heading, predicted.delay, ability) +
                 Radians{missing});
}

Bends LookAheadFollower::curve() const { return {path_, path_.startOf(begin_), path_.startOf(stop_), kBendWindow}; }

SpeedLimit LookAheadFollower::speedLimit(const PredictedState& predicted, Radians error, Metres gate) const {
  // The wheels are late as well: the speed is to be right where a slower stretch begins.
  const Seconds delay = predicted.delay + plan_.ability().lag;
  const Metres doubt = kSurely * predicted.state.sigma;
  SpeedLimit stretch = legs_.at(along(), doubt, delay, plan_, skipped_);
  stretch = stricter(stretch, bends_.at(progress_, {}, delay, plan_));
  if (guard_) stretch = stricter(stretch, guard_->limits().at(progress_, doubt, delay, plan_));
  return plan_.at({path_.startOf(stop_) - progress_, stop_ == path_.legCount(), predicted.delay, predicted.state.sigma,
                   error, stretch, gate - progress_, predicted.state.headingSigma});
}

Metres LookAheadFollower::lookAheadHere(const PredictedState& predicted) const {
  SpeedPlanOptions options = plan_.options();
  const bool end = stop_ == path_.legCount() && path_.startOf(stop_) - progress_ < options.endApproach;
  if (end) options.shortestLook = options.endLook;
  return lookAhead(std::max(predicted.state.speed, options.creep), predicted.delay, plan_.ability(), options);
}

Decision LookAheadFollower::arrive(const PredictedState& predicted, Seconds now) {
  const VehicleState& state = predicted.state;
  const Point end = path_.at(path_.startOf(stop_));
  const Radians along = path_.headingOf(stop_ - 1);
  const Offset left = turned(end - state.pose.position, -along);
  const bool sane = std::isfinite(predicted.delay.value());
  const Seconds delay = sane ? std::clamp(predicted.delay, kShortestHold, kLongestHold) : kLongestHold;
  if (!stoodSince_) {
    stoodSince_ = now;
    holding_ = state.pose.heading;
  }
  // Where it came to rest is told by a report that is made then; what it read on the last of the way comes with it.
  const auto settled = [&] { return now - *stoodSince_ >= 2.0 * delay + plan_.options().settling; };
  if (!inching_ && settled() && inched_ < kMostInches && left.x > kAtEnd) {
    inching_ = true;
    ++inched_;
  }
  if (inching_ && left.x > kAtEnd) {
    // No farther than the next command can stop it.
    Decision decision;
    decision.target = end + turned({plan_.options().endLook, Metres{}}, along);
    decision.command = {std::clamp(left.x / delay, kInching, plan_.options().creep),
                        direction(decision.target - state.pose.position)};
    decision.phase = Phase::OnLeg;
    decision.speedReason = SpeedReason::End;
    report(decision, state);
    return decision;
  }
  if (std::exchange(inching_, false)) {
    stoodSince_ = now;
    holding_ = state.pose.heading;
  }
  finished_ = settled();
  Decision standing = stand(finished_ ? Phase::Finished : Phase::OnLeg, holding_, state);
  if (!finished_) standing.speedReason = SpeedReason::End;
  return standing;
}

Decision LookAheadFollower::decide(const PredictedState& predicted, Seconds now) {
  const VehicleState& state = predicted.state;
  const Point here = state.pose.position;
  if (finished_) return stand(Phase::Finished, holding_, state);
  const double sane = here.x.value() + here.y.value() + state.pose.heading.value() + state.speed.value();
  if (!state.located || !std::isfinite(sane))
    return stand(Phase::Lost, std::isfinite(state.pose.heading.value()) ? state.pose.heading : Radians{}, state);
  if (!laid_) layPath(here);

  Polyline::Projection near = nearest(here);
  if (distance(near.nearest, here) > kOffRoute) {
    layPath(here);
    near = path_.project(here, Metres{}, Metres{});
  }
  progress_ = std::max(progress_, near.along);
  across_ = near.across;

  if (path_.startOf(stop_) - progress_ <= plan_.options().stopTolerance) {
    progress_ = path_.startOf(stop_);
    if (stop_ == path_.legCount()) {
      return arrive(predicted, now);
    }
    turning_ = true;
    findStop();
    across_ = nearest(here).across;
  }

  const Metres gate = guard_ ? guard_->mayGoTo(progress_, plan_.stoppingWay(predicted.delay + plan_.ability().lag))
                             : Metres{std::numeric_limits<double>::infinity()};
  const bool waited = std::exchange(waiting_, gate - progress_ <= plan_.options().stopTolerance);
  if (waiting_) {
    if (!waited) holding_ = state.pose.heading;
    return stand(Phase::Waiting, holding_, state);
  }

  const Metres look = lookAheadHere(predicted);
  Decision decision;
  decision.target = aim(look);
  const bool curved = stop_ - begin_ > 1;
  // Straight on the two are the same: towards the line, the more so the farther away it is.
  const Radians heading = curved
                              ? wrapped(curve().heading(progress_) - Radians{std::atan2(across_.value(), look.value())})
                              : direction(decision.target - here);
  const Radians error = turnBetween(state.pose.heading, heading);
  if (abs(error) > kMisaligned) turning_ = true;
  if (abs(error) < kAligned) turning_ = false;
  if (turning_) {
    Decision turning = stand(progress_ < approach_ ? Phase::Approaching : Phase::Turning, heading, state);
    turning.target = decision.target;
    turning.speedReason = SpeedReason::Heading;
    return turning;
  }
  const SpeedLimit limit = speedLimit(predicted, error, gate);
  decision.command = {limit.speed, curved ? holdOnCurve(predicted, heading) : heading};
  decision.phase = progress_ < approach_ ? Phase::Approaching : Phase::OnLeg;
  decision.speedReason = limit.reason;
  report(decision, state);
  return decision;
}

}  // namespace tessera::drive
