#include "drive/unicycle.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"

namespace tessera::test {
namespace {

constexpr double kUnicycleStep = 0.001;   // s
constexpr double kUnicyclePeriod = 0.05;  // s
constexpr double kUnicycleLag = 0.1;      // s
constexpr double kUnicycleSpeed = 0.5;    // m/s
constexpr double kUnicycleLimit = 120.0;  // s
constexpr double kArcStep = 3.0;          // degrees

drive::VehicleAbility unicycleAbility() {
  drive::VehicleAbility ability;
  ability.lag = ability.usualLag = Seconds{kUnicycleLag};
  ability.maxTurnRate = RadiansPerSecond{2.5};
  // It turns as it is told, without a ramp, and is never slower for it.
  ability.track = Metres{0.01};
  ability.fullSpeedError = ability.turnFirstError = Radians{kPi};
  return ability;
}

}  // namespace

floor::Route roundedRoute(double radius) {
  floor::Route route{"rounded", {{}}, Metres{0.2}};
  Pose at{{}, Radians{}};
  const auto forward = [&](double way) {
    at.position = at.position + turned({Metres{way}, {}}, at.heading);
    route.vertices.push_back(at.position);
  };
  const double chord = 2.0 * radius * std::sin(fromDegrees(kArcStep).value() / 2.0);
  for (const double side : {1.0, -1.0, -1.0, 1.0}) {
    forward(2.0 - 2.0 * radius);
    const Radians step = side * fromDegrees(kArcStep);
    for (int i = 0; i < static_cast<int>(90.0 / kArcStep); ++i) {
      at.heading += 0.5 * step;
      forward(chord);
      at.heading += 0.5 * step;
    }
  }
  forward(2.0 - 2.0 * radius);
  return route;
}

UnicycleRun driveUnicycle(std::string_view follower, const floor::Route& route) {
  const drive::VehicleAbility ability = unicycleAbility();
  drive::FollowerSetup setup{route, ability, {}};
  setup.plan.requested = MetresPerSecond{kUnicycleSpeed};
  const auto leader = drive::makeRouteFollower(follower, setup).value();
  const Polyline line{route.vertices};
  Pose pose{line.vertices().front(), line.headingOf(0)};
  double speed = 0, rate = 0, speedAsked = 0, rateAsked = 0, squares = 0, best = 0;
  UnicycleRun run;
  int steps = 0;
  for (; !run.finished && steps * kUnicycleStep < kUnicycleLimit; ++steps) {
    if (steps % static_cast<int>(std::lround(kUnicyclePeriod / kUnicycleStep)) == 0) {
      const Seconds now{steps * kUnicycleStep};
      const drive::VehicleState state{now, pose, MetresPerSecond{speed}, RadiansPerSecond{rate}, Metres{0.0}, true};
      const drive::Decision d = leader->decide({state, Seconds{kUnicyclePeriod}}, now);
      run.finished = d.phase == drive::Phase::Finished;
      speedAsked = d.command.speed.value();
      // The rate that the heading means, by drive::headingToTurn.
      const double perError = 1.0 / (1.0 / ability.headingGain + 0.5 * kUnicyclePeriod);
      const double most = ability.maxTurnRate.value();
      rateAsked = std::clamp(perError * turnBetween(pose.heading, d.command.heading).value(), -most, most);
    }
    speed += (speedAsked - speed) * kUnicycleStep / kUnicycleLag;
    rate += (rateAsked - rate) * kUnicycleStep / kUnicycleLag;
    pose.position = pose.position + turned({Metres{speed * kUnicycleStep}, {}}, pose.heading);
    pose.heading = wrapped(pose.heading + Radians{rate * kUnicycleStep});
    const auto near = line.project(pose.position, Metres{best - 0.2}, Metres{best + 0.2});
    best = std::max(best, near.along.value());
    squares += near.across.value() * near.across.value();
    run.crossTrackMax = std::max(run.crossTrackMax, std::abs(near.across.value()));
  }
  run.seconds = steps * kUnicycleStep;
  run.crossTrackRms = std::sqrt(squares / steps);
  return run;
}

}  // namespace tessera::test
