// From Ctrl(V, Dir) to a speed and a turn rate: holds the nose on a bearing, turns before it drives when the bearing is
// far off, and changes neither speed nor turn rate faster than the vehicle can.
#pragma once

#include "firmware/vehicle/settings.h"

namespace tessera::firmware {

/// Speed of the middle between the wheels (m/s, forwards) and turn rate (rad/s, counter-clockwise), with their rates.
struct Motion {
  float speed = 0.0F;
  float turnRate = 0.0F;
  float acceleration = 0.0F;
  float turnAcceleration = 0.0F;
};

class DriveControl {
public:
  void configure(const Settings& settings);

  /// Each of these is one tick of 10 ms.
  /// Hold `bearing` (radians clockwise from north, where `nose` is the present one) at `speed`; negative drives
  /// backwards with the nose on the bearing. Speed 0 turns on the spot.
  Motion hold(float speed, float bearing, float nose);
  /// Turn on the spot at a rate.
  Motion spin(float turnRate);
  /// Come to a stand, three times as hard as in normal driving.
  Motion stop();
  /// Stand at once, as far as the wishes go.
  void halt();

  /// The nose is being brought to the bearing with the vehicle on the spot.
  [[nodiscard]] bool turning() const { return turning_; }
  /// Nothing is wanted any more: speed and turn rate are zero.
  [[nodiscard]] bool standing() const { return motion_.speed == 0.0F && motion_.turnRate == 0.0F; }

private:
  Motion approach(float speed, float turnRate, float hardness);

  float maxSpeed_ = 0.5F;
  float maxTurnRate_ = 1.5F;
  float acceleration_ = 0.5F;
  float turnAcceleration_ = 3.3F;
  float halfTrack_ = 0.15F;
  bool turning_ = false;
  Motion motion_;
};

}  // namespace tessera::firmware
