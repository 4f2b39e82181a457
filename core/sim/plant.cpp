#include "sim/plant.h"

#include <algorithm>
#include <cmath>

namespace tessera::sim {

Pose advancedAlongArc(const Pose& from, Metres way, Radians turn) {
  // The chord of an arc of length s that turns by a is s * sin(a/2) / (a/2) long and points along the mean heading.
  const double half = turn.value() / 2.0;
  const double ratio = std::abs(half) < 1e-6 ? 1.0 - half * half / 6.0 : std::sin(half) / half;
  const Offset chord = turned({way * ratio, Metres{}}, from.heading + Radians{half});
  return {from.position + chord, wrapped(from.heading + turn)};
}

Plant::Plant(const PlantParameters& parameters, const Pose& start, RandomStream random)
    : parameters_{parameters}, pose_{start}, random_{random} {
  const double common = random_.normal(parameters_.scaleError);
  double own = -0.5 * parameters_.tyreDifference;
  for (Wheel& wheel : wheels_) {
    wheel.gain = 1.0 + random_.normal(parameters_.motorMismatch);
    wheel.diameter =
        parameters_.wheelDiameter.value() * (1.0 + common + own + random_.normal(parameters_.scaleDifference));
    own = -own;
    wheel.slip = random_.normal(parameters_.slipWander);
  }
}

void Plant::drive(Wheel& wheel, double dt, int duty, double volts) const {
  if (wheel.blocked) {
    wheel.surfaceSpeed = 0.0;
    return;
  }
  const double limited = std::clamp(duty, -1000, 1000) / 1000.0;
  const double wanted = wheel.gain * parameters_.speedAtFullDuty.value() * limited * volts / parameters_.nominalVolts;
  const bool stands = wheel.surfaceSpeed == 0.0;
  if (stands && std::abs(wanted) < parameters_.deadBand.value()) return;
  const double direction = stands ? wanted : wheel.surfaceSpeed;
  const double settled = wanted - std::copysign(parameters_.friction.value(), direction);
  const double lag = parameters_.motorLag.value() * (duty == 0 ? 0.5 : 1.0);
  const double next = settled + (wheel.surfaceSpeed - settled) * std::exp(-dt / lag);
  // Friction stops a wheel, it never turns it round: through zero only by the motor, in the next step.
  wheel.surfaceSpeed = !stands && next * wheel.surfaceSpeed <= 0.0 ? 0.0 : next;
}

double Plant::groundSpeed(Wheel& wheel, double dt) {
  if (wheel.surfaceSpeed == 0.0) return 0.0;
  // First-order Gauss-Markov process: standard deviation and correlation time do not depend on the step.
  const double keep = std::exp(-dt / parameters_.slipMemory.value());
  wheel.slip = keep * wheel.slip + random_.normal(parameters_.slipWander * std::sqrt(1.0 - keep * keep));
  return wheel.surfaceSpeed * (1.0 - parameters_.slip + wheel.slip + commonSlip_);
}

void Plant::wander(double dt) {
  if (parameters_.speedNoise == 0.0) return;  // and no random number is drawn: other runs stay as they are
  const double keep = std::exp(-dt / parameters_.speedNoiseMemory.value());
  commonSlip_ = keep * commonSlip_ + random_.normal(parameters_.speedNoise * std::sqrt(1.0 - keep * keep));
}

void Plant::step(Seconds dt, const std::array<int, 2>& duty, double volts) {
  std::array<double, 2> speed{};
  std::array<double, 2> way{};
  wander(dt.value());
  for (std::size_t i = 0; i < wheels_.size(); ++i) {
    Wheel& wheel = wheels_[i];
    drive(wheel, dt.value(), duty[i], volts);
    wheel.angle += wheel.surfaceSpeed * dt.value() / (wheel.diameter / 2.0);
    speed[i] = groundSpeed(wheel, dt.value());
    // A random walk along the way: joints, grains, an uneven floor.
    way[i] = speed[i] * dt.value();
    way[i] += random_.normal(parameters_.wayNoise * std::sqrt(std::abs(way[i])));
  }
  const double track = parameters_.track.value();
  pose_ = advancedAlongArc(pose_, Metres{(way[0] + way[1]) / 2.0}, Radians{(way[1] - way[0]) / track});
  speed_ = MetresPerSecond{(speed[0] + speed[1]) / 2.0};
  turnRate_ = RadiansPerSecond{(speed[1] - speed[0]) / track};
}

std::array<std::int64_t, 2> Plant::encoderCounts() const {
  const auto counts = [this](const Wheel& wheel) {
    return static_cast<std::int64_t>(std::floor(wheel.angle / (2.0 * kPi) * parameters_.countsPerTurn));
  };
  return {counts(wheels_[0]), counts(wheels_[1])};
}

}  // namespace tessera::sim
