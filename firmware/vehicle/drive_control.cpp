#include "firmware/vehicle/drive_control.h"

#include <algorithm>

#include "firmware/vehicle/angles.h"
#include "firmware/vehicle/time.h"

namespace tessera::firmware {
namespace {

using wire::Parameter;

constexpr float degrees(float d) { return d * kPi / 180.0F; }

constexpr float kHeadingGain = 3.0F;   // 1/s
constexpr float kBrakingShare = 0.5F;  // of the turn acceleration, for the approach to the bearing
constexpr float kStopHardness = 3.0F;
constexpr float kFullSpeedError = degrees(10);  // up to here the speed is as commanded ...
constexpr float kTurnFirst = degrees(30);       // ... and from here on it is zero
constexpr float kTurnedEnough = degrees(15);
constexpr float kStandTolerance = degrees(0.5F);
constexpr float kLeaveStand = degrees(2);

float towards(float from, float to, float step) { return from + std::clamp(to - from, -step, step); }

}  // namespace

void DriveControl::configure(const Settings& settings) {
  maxSpeed_ = static_cast<float>(settings.get(Parameter::MaxSpeed)) * 1e-3F;
  maxTurnRate_ = static_cast<float>(settings.get(Parameter::MaxTurnRate)) * 1e-3F;
  acceleration_ = static_cast<float>(settings.get(Parameter::Acceleration)) * 1e-3F;
  halfTrack_ = static_cast<float>(settings.get(Parameter::TrackWidth)) * 0.5e-6F;
  turnAcceleration_ = acceleration_ / halfTrack_;
}

Motion DriveControl::hold(float speed, float bearing, float nose) {
  const float error = wrapAngle(nose - bearing);  // counter-clockwise turn that is still to be made
  const float size = std::fabs(error);
  const bool onTheSpot = speed == 0.0F;
  if (turning_)
    turning_ = size > (onTheSpot ? kStandTolerance : kTurnedEnough);
  else
    turning_ = size > (onTheSpot ? kLeaveStand : kTurnFirst);
  float rate = 0.0F;
  if (!onTheSpot || turning_) {
    rate = std::min({kHeadingGain * size, std::sqrt(2.0F * kBrakingShare * turnAcceleration_ * size), maxTurnRate_});
    rate = std::min(rate, maxSpeed_ / halfTrack_);
    if (error < 0.0F) rate = -rate;
  }
  const float share = turning_ ? 0.0F : std::clamp((kTurnFirst - size) / (kTurnFirst - kFullSpeedError), 0.0F, 1.0F);
  const float room = std::max(0.0F, maxSpeed_ - std::fabs(rate) * halfTrack_);  // for the outer wheel
  return approach(std::clamp(speed * share, -room, room), rate, 1.0F);
}

Motion DriveControl::spin(float turnRate) {
  turning_ = true;
  return approach(0.0F, std::clamp(turnRate, -maxTurnRate_, maxTurnRate_), 1.0F);
}

Motion DriveControl::stop() {
  turning_ = false;
  return approach(0.0F, 0.0F, kStopHardness);
}

void DriveControl::halt() {
  turning_ = false;
  motion_ = {};
}

Motion DriveControl::approach(float speed, float turnRate, float hardness) {
  const float before = motion_.speed;
  const float rateBefore = motion_.turnRate;
  motion_.speed = towards(before, speed, hardness * acceleration_ * kTickSeconds);
  motion_.turnRate = towards(rateBefore, turnRate, hardness * turnAcceleration_ * kTickSeconds);
  motion_.acceleration = (motion_.speed - before) / kTickSeconds;
  motion_.turnAcceleration = (motion_.turnRate - rateBefore) / kTickSeconds;
  return motion_;
}

}  // namespace tessera::firmware
