#include "drive/predictor.h"

#include <algorithm>
#include <cmath>

namespace tessera::drive {
namespace {

constexpr double kStep = 0.02;           // s
constexpr double kLongest = 5.0;         // s
constexpr double kRest = 1e-4;           // m/s, rad/s, rad: no more worth rolling
constexpr double kDoubtPerMetre = 0.05;  // of the way rolled: the vehicle never does quite what the model says

double towards(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }

/// Share of the commanded speed that a vehicle drives at while its nose is off by this much.
double shareAt(double error, const VehicleAbility& ability) {
  const double easy = ability.fullSpeedError.value();
  const double turnFirst = std::max(ability.turnFirstError.value(), easy + 1e-6);
  return std::clamp((turnFirst - std::abs(error)) / (turnFirst - easy), 0.0, 1.0);
}

}  // namespace

VehicleAbility abilityOf(const floor::VehicleSetup& setup) {
  VehicleAbility ability;
  ability.maxSpeed = setup.maxSpeed;
  ability.maxTurnRate = setup.maxTurnRate;
  ability.acceleration = setup.acceleration;
  ability.cornerCut = setup.cornerCut;
  return ability;
}

VehicleState predict(const VehicleState& state, std::span<const TimedCommand> commands, Seconds until,
                     const VehicleAbility& ability) {
  VehicleState s = state;
  const double end = std::min(until.value(), state.at.value() + kLongest);
  const double share = 1.0 - std::exp(-kStep / std::max(ability.usualLag.value(), 1e-3));
  double set = s.speed.value();  // the ramp that the wheels follow
  double heading = s.pose.heading.value();
  Command hold{MetresPerSecond{0.0}, s.pose.heading};
  std::size_t next = 0;
  for (double t = s.at.value(); t < end; t += kStep) {
    while (next < commands.size() && commands[next].from.value() <= t) ++next;
    const bool driven = next > 0 && t < commands[next - 1].until.value();
    if (next > 0) hold.heading = commands[next - 1].command.heading;
    const double error = turnBetween(Radians{heading}, hold.heading).value();
    const bool rests = next == commands.size() && !driven && set == 0.0 && std::abs(s.speed.value()) < kRest &&
                       std::abs(s.turnRate.value()) < kRest && std::abs(error) < kRest;
    if (rests) {
      s.speed = MetresPerSecond{};
      s.turnRate = RadiansPerSecond{};
      break;
    }
    const double wanted = driven ? commands[next - 1].command.speed.value() * shareAt(error, ability) : 0.0;
    const double dt = std::min(kStep, end - t);
    const double part = share * dt / kStep;
    set = towards(set, wanted, ability.acceleration.value() * dt);
    s.speed += MetresPerSecond{part * (set - s.speed.value())};
    const double rate =
        std::clamp(ability.headingGain * error, -ability.maxTurnRate.value(), ability.maxTurnRate.value());
    s.turnRate += RadiansPerSecond{part * (rate - s.turnRate.value())};
    const double way = s.speed.value() * dt;
    const double turn = s.turnRate.value() * dt;
    s.pose.position = s.pose.position + turned({Metres{way}, Metres{}}, Radians{heading + 0.5 * turn});
    heading += turn;
    s.sigma += Metres{kDoubtPerMetre * std::abs(way)};
  }
  s.pose.heading = wrapped(Radians{heading});
  s.at = std::max(state.at, Seconds{end});
  return s;
}

}  // namespace tessera::drive
