// Rolls a vehicle's state forward through the commands that are under way, so that the radio's delay leaves the
// control loop (state predictor over a network: Alvarez-Aguirre et al., IEEE TCST 22(6), 2014).
#pragma once

#include <span>

#include "drive/command.h"

namespace tessera::drive {

/// What the controller needs of an estimate; copy it from locate::Estimate.
struct VehicleState {
  Seconds at;
  Pose pose;
  MetresPerSecond speed;
  RadiansPerSecond turnRate;
  Metres sigma;            ///< standard deviation of the place
  bool located = true;     ///< false: the controller stands still
  Radians headingSigma{};  ///< standard deviation of the heading
  bool turning = false;    ///< it stands, or brakes, to be turned first
};

/// The state expected at `until`, when commands were in force as listed (sorted by `from`; a later one takes over from
/// an earlier one; where none is in force the vehicle brakes and turns no further). Rolls 5 s at most; `until` before
/// state.at returns the state as it is. Sigma grows with the distance rolled.
[[nodiscard]] VehicleState predict(const VehicleState& state, std::span<const TimedCommand> commands, Seconds until,
                                   const VehicleAbility& ability);

}  // namespace tessera::drive
