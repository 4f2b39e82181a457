// What the controller tells a vehicle, and what is known of the vehicle's ability to obey.
#pragma once

#include "base/pose.h"
#include "floor/site.h"

namespace tessera::drive {

/// Ctrl(V, Dir) of the publication: hold this speed and this heading until the next command.
struct Command {
  MetresPerSecond speed;  ///< 0: stand, and turn on the spot if the heading asks for it
  Radians heading;  ///< true heading in the site frame; the compass' bias is added where the wire's bearing is made
  bool operator==(const Command&) const = default;
};

/// A command and the span in which it is (or is expected to be) in force on the vehicle, by the host's clock. `until`
/// is where the next takes over or it expires; then the vehicle brakes, turning no further.
struct TimedCommand {
  Command command;
  Seconds from;
  Seconds until;
};

/// How a vehicle obeys: its heading loop turns it by headingGain·error, limited; its speed goes in ramps; while it is
/// off the commanded heading it drives slower, and far off it turns on the spot first.
struct VehicleAbility {
  MetresPerSecond maxSpeed{0.5};
  RadiansPerSecond maxTurnRate{1.5};
  MetresPerSecond2 acceleration{0.5};
  Seconds lag{0.10};             ///< of wheels behind their set speed, as plans allow for it ...
  Seconds usualLag{0.03};        ///< ... and what the firmware's feed-forward leaves of it, for predictions
  double headingGain = 3.0;      ///< 1/s, of the vehicle's heading hold
  Radians fullSpeedError{0.17};  ///< up to this heading error it drives at the commanded speed ...
  Radians turnFirstError{0.52};  ///< ... and from this one on it stands and turns ...
  Radians turnedEnough{0.26};    ///< ... until no more than this is left
  Metres track{0.30};            ///< between the driven wheels: with the acceleration, how soon it turns
  Metres cornerCut{0.0};         ///< by which it may leave a sharp corner; 0: it turns there on the spot
};

[[nodiscard]] VehicleAbility abilityOf(const floor::VehicleSetup& setup);

}  // namespace tessera::drive
