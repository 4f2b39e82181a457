#include "supervisor/hand_drive.h"

#include <algorithm>
#include <cmath>

namespace tessera::supervisor {
namespace {

constexpr double kLargestLead = 1.5;           // rad, on the spot
constexpr double kLargestLeadInMotion = 0.42;  // rad; further off the vehicle would stand and turn first

}  // namespace

bool HandDrive::take(const Jog& order, Seconds now) {
  const bool held = last_ && now < *last_ + kJogHolds;
  last_ = now;
  barred_ = barred_ && held;
  if (barred_) return false;
  if (!held) straight_.reset();
  const MetresPerSecond most = std::min(kJogFastest, ability_.maxSpeed);
  speed_ = std::clamp(order.speed, -most, most);
  turnRate_ = std::clamp(order.turnRate, -ability_.maxTurnRate, ability_.maxTurnRate);
  return true;
}

void HandDrive::bar(Seconds now) {
  if (last_ && now < *last_ + kJogHolds) barred_ = true;
}

drive::Command HandDrive::command(Radians nose, Seconds cycle) {
  if (turnRate_ == RadiansPerSecond{}) {
    if (!straight_) straight_ = nose;
    return {speed_, *straight_};
  }
  straight_.reset();
  // The vehicle turns by gain * error, so within a cycle it covers this share of the lead.
  const double time = std::max(cycle.value(), 0.01);
  const double share = 1.0 - std::exp(-ability_.headingGain * time);
  const double most = speed_ == MetresPerSecond{} ? kLargestLead : kLargestLeadInMotion;
  const double lead = std::clamp(turnRate_.value() * time / share, -most, most);
  return {speed_, wrapped(nose + Radians{lead})};
}

}  // namespace tessera::supervisor
