// Turns a 24-bit counter that counts down and wraps three times a second into microseconds that wrap after 71 minutes.
#pragma once

#include <cstdint>

namespace tessera::firmware::lm3s6965 {

/// Exact as long as it is asked at least once per wrap of the counter: 2^24 ticks, 0.33 s at 50 MHz.
template <std::uint32_t TicksPerMicro>
class MicrosCounter {
public:
  static constexpr std::uint32_t kMask = 0xFFFFFF;

  explicit MicrosCounter(std::uint32_t raw = kMask) : last_{raw & kMask} {}

  /// The time, given what the counter shows now. What is left of a microsecond is carried, so that nothing drifts.
  std::uint32_t advance(std::uint32_t raw) {
    rest_ += (last_ - raw) & kMask;
    last_ = raw & kMask;
    micros_ += rest_ / TicksPerMicro;
    rest_ %= TicksPerMicro;
    return micros_;
  }

private:
  std::uint32_t last_;
  std::uint32_t rest_ = 0;
  std::uint32_t micros_ = 0;
};

}  // namespace tessera::firmware::lm3s6965
