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

void Heading::compass(float bearing) {
  const float innovation = wrapAngle(bearing - bearing_);
  if (samples_ > 0 && std::fabs(innovation) > kFar) {
    if (++far_ < kFarToBelieve) return;
    samples_ = 0;
  }
  far_ = 0;
  if (samples_ == 0) {
    bearing_ = wrapAngle(bearing);
    known_ = true;
    samples_ = 1;
    return;
  }
  float gain = ratio_;
  if (samples_ < kAveraged) gain = std::max(gain, 1.0F / static_cast<float>(++samples_));
  bearing_ = wrapAngle(bearing_ + gain * std::clamp(innovation, -kClip, kClip));
}

}  // namespace tessera::firmware
