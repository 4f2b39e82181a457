#include "drive/predictor.h"

#include <algorithm>
#include <cmath>

namespace tessera::drive {
namespace {

constexpr double kStep = 0.01;              // s, as in the firmware
constexpr double kLongest = 5.0;            // s
constexpr double kRest = 1e-4;              // m/s, rad/s, rad: no more worth rolling
constexpr double kBrakingShare = 0.5;       // of the turn acceleration, for the approach to a heading
constexpr double kStandTolerance = 0.0087;  // rad, at which a turn on the spot ends ...
constexpr double kLeaveStand = 0.035;       // ... and from which one begins
constexpr double kStopHardness = 3.0;       // times the usual ramps, where no command is in force
constexpr double kDoubtPerMetre = 0.05;     // of the way rolled: the vehicle never does quite what the model says

double halfTrack(const VehicleAbility& ability) { return 0.5 * std::max(ability.track.value(), 1e-3); }

double turnAcceleration(const VehicleAbility& ability) { return ability.acceleration.value() / halfTrack(ability); }

double towards(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }

/// What the wheels are to do: speed of their middle and turn rate, each behind its ramp.
struct Wish {
  double speed = 0.0;
  double rate = 0.0;
  double hardness = 1.0;  ///< times the usual ramps
};

/// The firmware's way from a command to the wheels (firmware/vehicle/drive_control.h).
Wish wishFor(const Command& command, double error, bool& turning, const VehicleAbility& ability) {
  const double size = std::abs(error);
  const bool onTheSpot = command.speed == MetresPerSecond{};
  if (turning)
    turning = size > (onTheSpot ? kStandTolerance : ability.turnedEnough.value());
  else
    turning = size > (onTheSpot ? kLeaveStand : ability.turnFirstError.value());
  if (onTheSpot && !turning) return {};
  const double rate =
      std::min({ability.headingGain * size, std::sqrt(2.0 * kBrakingShare * turnAcceleration(ability) * size),
                ability.maxTurnRate.value(), ability.maxSpeed.value() / halfTrack(ability)});
  const double easy = ability.fullSpeedError.value();
  const double turnFirst = std::max(ability.turnFirstError.value(), easy + 1e-6);
  const double share = turning ? 0.0 : std::clamp((turnFirst - size) / (turnFirst - easy), 0.0, 1.0);
  const double room = std::max(0.0, ability.maxSpeed.value() - rate * halfTrack(ability));
  return {std::clamp(command.speed.value() * share, -room, room), std::copysign(rate, error)};
}

}  // namespace

VehicleAbility abilityOf(const floor::VehicleSetup& setup) {
  VehicleAbility ability;
  ability.maxSpeed = setup.maxSpeed;
  ability.maxTurnRate = setup.maxTurnRate;
  ability.acceleration = setup.acceleration;
  ability.cornerCut = setup.cornerCut;
  ability.track = setup.track;
  return ability;
}

VehicleState predict(const VehicleState& state, std::span<const TimedCommand> commands, Seconds until,
                     const VehicleAbility& ability) {
  VehicleState s = state;
  const double end = std::min(until.value(), state.at.value() + kLongest);
  const double share = 1.0 - std::exp(-kStep / std::max(ability.usualLag.value(), 1e-3));
  double speed = s.speed.value();  // the ramps that the wheels follow
  double rate = s.turnRate.value();
  double heading = s.pose.heading.value();
  std::size_t next = 0;
  for (double t = s.at.value(); t < end; t += kStep) {
    while (next < commands.size() && commands[next].from.value() <= t) ++next;
    const bool driven = next > 0 && t < commands[next - 1].until.value();
    Wish wish{0.0, 0.0, kStopHardness};
    if (driven) {
      const Command& command = commands[next - 1].command;
      wish = wishFor(command, turnBetween(Radians{heading}, command.heading).value(), s.turning, ability);
    } else {
      s.turning = false;
      if (next == commands.size() && speed == 0.0 && rate == 0.0 && std::abs(s.speed.value()) < kRest &&
          std::abs(s.turnRate.value()) < kRest) {
        s.speed = MetresPerSecond{};
        s.turnRate = RadiansPerSecond{};
        break;
      }
    }
    const double dt = std::min(kStep, end - t);
    const double part = share * dt / kStep;
    speed = towards(speed, wish.speed, wish.hardness * ability.acceleration.value() * dt);
    rate = towards(rate, wish.rate, wish.hardness * turnAcceleration(ability) * dt);
    s.speed += MetresPerSecond{part * (speed - s.speed.value())};
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
