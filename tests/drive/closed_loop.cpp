#include "drive/closed_loop.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

namespace tessera::test {
namespace {

constexpr double kStep = 0.005;
constexpr double kRest = 1.0;  // s after the last command in which the vehicle comes to rest

class Vehicle {
public:
  Vehicle(const Pose& start, const LoopOptions& options) : pose_{start}, o_{options} {
    command_.heading = start.heading;
  }

  void obey(const drive::Command& command) { command_ = command; }
  void carry(Offset by) { pose_.position = pose_.position + by; }
  void step() {
    const double error = turnBetween(pose_.heading, command_.heading).value();
    // As the firmware does it: more than 30° off it turns on the spot until 15° are left, from 10° on it drives slower.
    turning_ = std::abs(error) > (turning_ ? 0.26 : 0.52);
    const double share = turning_ ? 0.0 : std::clamp((0.52 - std::abs(error)) / 0.35, 0.0, 1.0);
    const double wanted = command_.speed.value() * share;
    ramp_ += std::clamp(wanted - ramp_, -o_.acceleration * kStep, o_.acceleration * kStep);
    speed_ += (ramp_ - speed_) * kStep / o_.lag;
    rate_ += (std::clamp(o_.gain * error, -1.5, 1.5) - rate_) * kStep / o_.lag;
    pose_.position = pose_.position + turned({Metres{speed_ * kStep}, Metres{}}, pose_.heading);
    pose_.heading = wrapped(pose_.heading + Radians{rate_ * kStep});
  }
  [[nodiscard]] const Pose& pose() const { return pose_; }
  [[nodiscard]] double speed() const { return speed_; }
  [[nodiscard]] double rate() const { return rate_; }

private:
  Pose pose_;
  LoopOptions o_;
  drive::Command command_;
  double ramp_ = 0.0, speed_ = 0.0, rate_ = 0.0;
  bool turning_ = false;
};

/// Follows the true place along the route in a window, so that legs near to each other are not confused.
class Judge {
public:
  /// Round a corner that is cut the nearest place moves from leg to leg by more than the cut.
  Judge(const Polyline& route, double cut) : route_{route}, window_{0.15 + cut} {
    result.topSpeeds.resize(route.legCount());
    nearest_.resize(route.vertices().size(), 1e9);
  }
  void see(Point here, double speed) {
    const auto near = route_.project(here, Metres{best_ - window_}, Metres{best_ + window_});
    const double across = std::abs(near.across.value());
    if (!begun_ && across > 0.02) return;
    begun_ = true;
    squares_ += across * across;
    ++count_;
    result.crossTrackMax = std::max(result.crossTrackMax, across);
    result.largestLoss = std::max(result.largestLoss, best_ - near.along.value());
    best_ = std::max(best_, near.along.value());
    for (std::size_t v = 0; v < nearest_.size(); ++v)
      nearest_[v] = std::min(nearest_[v], distance(route_.vertices()[v], here).value());
    if (best_ > 0.15 && best_ < route_.length().value() - 0.15)
      result.lowestSpeed = std::min(result.lowestSpeed, speed);
    double& top = result.topSpeeds[route_.legAt(near.along)];
    top = std::max(top, speed);
    const bool away = std::none_of(route_.vertices().begin(), route_.vertices().end(),
                                   [&](Point v) { return distance(v, here) < Metres{0.25}; });
    if (!away) return;
    cruise_ += speed;
    ++cruising_;
  }
  void finish() {
    if (count_ > 0) result.crossTrackRms = std::sqrt(squares_ / count_);
    result.missedVertex = *std::max_element(nearest_.begin(), nearest_.end());
    if (cruising_ > 0) result.cruise = cruise_ / cruising_;
  }
  LoopResult result;

private:
  const Polyline& route_;
  double window_;
  bool begun_ = false;
  double best_ = 0.0, squares_ = 0.0, cruise_ = 0.0;
  int count_ = 0, cruising_ = 0;
  std::vector<double> nearest_;
};

struct Noise {
  double sigma;
  double value = 0.0;
  void step(std::mt19937& random, double dt) {
    std::normal_distribution<double> normal;
    value += -value * dt + sigma * std::sqrt(2.0 * dt) * normal(random);
  }
};

class Loop {
public:
  Loop(std::string_view follower, const floor::Route& route, const LoopOptions& options)
      : o_{options},
        random_{options.seed},
        ability_{ability(options)},
        follower_{*drive::makeRouteFollower(follower, {route, ability_, plan(options)})},
        vehicle_{options.start.value_or(Pose{route.vertices[0], direction(route.vertices[1] - route.vertices[0])}),
                 options},
        judge_{follower_->route(), options.cut},
        x_{options.poseNoise},
        y_{options.poseNoise},
        heading_{options.headingNoise} {}

  LoopResult run() {
    double stopAt = o_.limit;
    for (; now_ < stopAt; now_ += kStep) {
      if (o_.carryAt && now_ >= *o_.carryAt) vehicle_.carry({Metres{-o_.carryBy}, Metres{}}), o_.carryAt.reset();
      measure();
      if (now_ >= nextDecision_ && measured_.size() > 1 && decide()) stopAt = std::min(stopAt, now_ + o_.up + kRest);
      while (!onTheWay_.empty() && onTheWay_.front().from.value() <= now_) {
        vehicle_.obey(onTheWay_.front().command);
        onTheWay_.pop_front();
      }
      vehicle_.step();
      judge_.see(vehicle_.pose().position, vehicle_.speed());
    }
    judge_.finish();
    judge_.result.duration = now_;
    judge_.result.endError = distance(vehicle_.pose().position, follower_->route().vertices().back()).value();
    return judge_.result;
  }

private:
  static drive::SpeedPlanOptions plan(const LoopOptions& options) {
    drive::SpeedPlanOptions plan;
    plan.requested = MetresPerSecond{options.speed};
    return plan;
  }

  static drive::VehicleAbility ability(const LoopOptions& options) {
    drive::VehicleAbility ability;
    ability.usualLag = ability.lag;
    ability.track = Metres{0.01};  // its turn rate follows without a ramp
    ability.cornerCut = Metres{options.cut};
    return ability;
  }

  void measure() {
    x_.step(random_, kStep);
    y_.step(random_, kStep);
    heading_.step(random_, kStep);
    const Pose& pose = vehicle_.pose();
    measured_.push_back(
        {Seconds{now_},
         {pose.position + Offset{Metres{x_.value}, Metres{y_.value}}, pose.heading + Radians{heading_.value}},
         MetresPerSecond{vehicle_.speed()},
         RadiansPerSecond{vehicle_.rate()},
         Metres{o_.poseNoise},
         true});
    while (measured_.size() > 1 && measured_[1].at.value() <= now_ - o_.down) measured_.pop_front();
  }

  bool decide() {
    nextDecision_ += o_.period;
    drive::VehicleState state = measured_.front();
    if (follower_->wantsPrediction()) state = drive::predict(state, sent_, Seconds{now_ + o_.up}, ability_);
    const drive::Decision d = follower_->decide({state, Seconds{o_.period + o_.jitter * o_.up}}, Seconds{now_});
    LoopResult& result = judge_.result;
    if (result.phases.empty() || result.phases.back() != d.phase) result.phases.push_back(d.phase);
    result.lowestCommand = std::min(result.lowestCommand, d.command.speed.value());
    if (!sent_.empty()) sent_.back().until = Seconds{now_ + o_.up};
    sent_.push_back({d.command, Seconds{now_ + o_.up}, Seconds{now_ + o_.up + 1.0}});
    const double spread = std::uniform_real_distribution<double>{-o_.jitter, o_.jitter}(random_);
    onTheWay_.push_back({d.command, Seconds{now_ + o_.up * (1.0 + spread)}, Seconds{}});
    const bool newlyDone = d.phase == drive::Phase::Finished && !result.finished;
    result.finished = result.finished || newlyDone;
    return newlyDone;
  }

  LoopOptions o_;
  std::mt19937 random_;
  drive::VehicleAbility ability_;
  std::unique_ptr<drive::RouteFollower> follower_;
  Vehicle vehicle_;
  Judge judge_;
  Noise x_, y_, heading_;
  std::deque<drive::VehicleState> measured_;
  std::vector<drive::TimedCommand> sent_;
  std::deque<drive::TimedCommand> onTheWay_;
  double now_ = 0.0;
  double nextDecision_ = 0.0;
};

}  // namespace

floor::Route paperRoute() {
  floor::Route route;
  route.name = "paper";
  for (const auto& [x, y] : {std::pair{30, 30}, {30, 150}, {90, 150}, {90, 30}, {150, 30}, {150, 150}})
    route.vertices.push_back({Metres{x / 100.0}, Metres{y / 100.0}});
  return route;
}

LoopResult closeLoop(std::string_view follower, const floor::Route& route, const LoopOptions& options) {
  return Loop{follower, route, options}.run();
}

}  // namespace tessera::test
