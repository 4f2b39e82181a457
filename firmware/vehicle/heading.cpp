#include "firmware/vehicle/heading.h"

#include <algorithm>

#include "firmware/vehicle/angles.h"

namespace tessera::firmware {
namespace {

constexpr int kAveraged = 50;        // samples at the start: one second
constexpr float kClip = kPi / 9.0F;  // 20 degrees: what disturbed floors do
constexpr float kFar = kPi / 4.0F;   // 45 degrees: no disturbance but another heading, or a spike
constexpr int kFarToBelieve = 50;

}  // namespace

void Heading::turn(float angle) { bearing_ = wrapAngle(bearing_ - angle); }

float Heading::compass(float bearing) {
  const float innovation = wrapAngle(bearing - bearing_);
  if (samples_ > 0 && std::fabs(innovation) > kFar) {
    if (++far_ < kFarToBelieve) return 0.0F;
    samples_ = 0;
  }
  far_ = 0;
  if (samples_ == 0) {
    bearing_ = wrapAngle(bearing);
    known_ = true;
    samples_ = 1;
    return 0.0F;
  }
  const bool starting = samples_ < kAveraged;
  const float gain = starting ? std::max(ratio_, 1.0F / static_cast<float>(++samples_)) : ratio_;
  const float correction = gain * std::clamp(innovation, -kClip, kClip);
  bearing_ = wrapAngle(bearing_ + correction);
  return starting ? 0.0F : correction;
}

}  // namespace tessera::firmware
