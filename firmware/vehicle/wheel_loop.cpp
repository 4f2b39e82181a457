#include "firmware/vehicle/wheel_loop.h"

#include <algorithm>
#include <cmath>

#include "firmware/vehicle/time.h"

namespace tessera::firmware {
namespace {

constexpr float kDt = kTickSeconds;
// A nominal motor: what feed-forward promises and the integral makes true. Speed at full duty, lag, and the speed that
// friction takes away.
constexpr float kFullSpeed = 0.80F;
constexpr float kLag = 0.10F;
constexpr float kFriction = 0.03F;
// With lag T the loop is T s² + (1 + P) s + I: P = 1, I = 5 gives a damping of 1.4 at T = 0.1 and of 0.8 at 0.3.
constexpr float kProportional = 1.0F;
constexpr float kIntegral = 5.0F;
constexpr float kMaxMissing = 0.15F;  // m; some full duty's worth
// Observer: both poles at 15/s, slow enough for edges 30 ms apart, fast enough for the loop.
constexpr float kPole = 15.0F;

constexpr float kHardDuty = 300.0F;
constexpr float kStill = 0.010F;    // m/s
constexpr float kAgainst = 0.030F;  // m/s
constexpr int kSettleTicks = 50;    // a released wheel may roll out

}  // namespace

void WheelLoop::measure(std::int32_t counts) {
  if (!measured_) counts_ = counts;
  measured_ = true;
  const auto moved =
      static_cast<std::int32_t>(static_cast<std::uint32_t>(counts) - static_cast<std::uint32_t>(counts_));
  counts_ = counts;
  step_ = static_cast<float>(moved) * metresPerCount_;
  speed_ += acceleration_ * kDt;  // what was ordered happens, more or less: without this the observer lags in ramps
  lead_ += step_ - speed_ * kDt;
  const float error = lead_;
  lead_ -= 2.0F * kPole * kDt * error;
  speed_ += kPole * kPole * kDt * error;
  watch();
}

void WheelLoop::watch() {
  const bool hard = std::abs(duty_) >= static_cast<int>(kHardDuty);
  const float along = duty_ < 0 ? -speed_ : speed_;
  stalledTicks_ = hard && std::fabs(speed_) < kStill ? std::min(stalledTicks_ + 1, kPatience)
                  : stalled()                        ? kPatience
                                                     : 0;
  const bool meant = wanted_ * static_cast<float>(duty_) > 0.0F;
  const bool against = hard && meant && along < -kAgainst;
  if (against)
    againstTicks_ = std::min(againstTicks_ + 1, kPatience);
  else if (againstTicks_ < kPatience)
    againstTicks_ = 0;
  if (duty_ != 0) {
    releasedTicks_ = 0;
  } else if (releasedTicks_ < kSettleTicks) {
    ++releasedTicks_;
    drift_ = implausible() ? drift_ : 0.0F;
  } else if (!implausible()) {
    drift_ += step_;
  }
}

std::int16_t WheelLoop::drive(float speed, float acceleration) {
  wanted_ = speed;
  acceleration_ = acceleration;
  if (speed == 0.0F) missing_ = 0.0F;  // a wheel that is to stand does not roll back
  const float friction = speed > 0.0F ? kFriction : speed < 0.0F ? -kFriction : 0.0F;
  const float more = speed == 0.0F ? 0.0F : speed * kDt - step_;
  const float missing = std::clamp(missing_ + more, -kMaxMissing, kMaxMissing);
  const float effort = speed + friction + kLag * acceleration + kProportional * (speed - speed_) + kIntegral * missing;
  const float duty = effort / kFullSpeed;
  // At the limit the missing way may shrink but not grow.
  if (std::fabs(duty) <= 1.0F || std::fabs(missing) < std::fabs(missing_)) missing_ = missing;
  duty_ = static_cast<std::int16_t>(std::lround(1000.0F * std::clamp(duty, -1.0F, 1.0F)));
  return duty_;
}

std::int16_t WheelLoop::release() {
  missing_ = 0.0F;
  wanted_ = 0.0F;
  acceleration_ = 0.0F;
  duty_ = 0;
  return duty_;
}

void WheelLoop::forgive() {
  stalledTicks_ = 0;
  againstTicks_ = 0;
  releasedTicks_ = 0;
  drift_ = 0.0F;
}

}  // namespace tessera::firmware
