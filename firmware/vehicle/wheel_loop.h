// One driven wheel: its way and speed from the encoder, its duty from a speed loop, and whether encoder and drive
// agree.
#pragma once

#include <cstdint>

namespace tessera::firmware {

/// To be run at 100 Hz: measure() first, then drive() or release(). Speeds are of the wheel's rim, m/s.
class WheelLoop {
public:
  /// metresPerCount: way of the rim for one encoder count.
  void configure(float metresPerCount) { metresPerCount_ = metresPerCount; }

  /// The encoder's counts as they stand now; they may wrap.
  void measure(std::int32_t counts);
  /// PI loop with feed-forward: the integral is the way that is missing, so that one count is never lost; it stops
  /// growing while the duty is at its limit. Speed and acceleration wanted. Returns the duty in 1/1000.
  std::int16_t drive(float speed, float acceleration);
  /// Brakes and forgets what was missing: duty 0.
  std::int16_t release();

  /// A tracking observer's: at 0.05 m/s and 200 counts a turn an edge comes only every third tick.
  [[nodiscard]] float speed() const { return speed_; }
  /// Way of the last tick, m.
  [[nodiscard]] float step() const { return step_; }
  /// The wheel does not turn although driven hard, for half a second.
  [[nodiscard]] bool stalled() const { return stalledTicks_ >= kPatience; }
  /// It turns against its drive for half a second, or has turned by more than 10 cm while braked.
  [[nodiscard]] bool implausible() const { return againstTicks_ >= kPatience || drift_ > kDrift || drift_ < -kDrift; }
  /// Forgets stalled() and implausible().
  void forgive();

private:
  static constexpr int kPatience = 50;
  static constexpr float kDrift = 0.10F;
  void watch();

  float metresPerCount_ = 0.0015708F;
  std::int32_t counts_ = 0;
  bool measured_ = false;
  float step_ = 0.0F;
  float speed_ = 0.0F;
  float lead_ = 0.0F;     ///< way of the encoder ahead of the observer's
  float missing_ = 0.0F;  ///< way wanted but not made yet
  float wanted_ = 0.0F;
  float acceleration_ = 0.0F;
  std::int16_t duty_ = 0;
  int stalledTicks_ = 0;
  int againstTicks_ = 0;
  int releasedTicks_ = 0;
  float drift_ = 0.0F;
};

}  // namespace tessera::firmware
