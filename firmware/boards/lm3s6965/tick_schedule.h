// Says when the 100 Hz work is due, from the free-running microseconds.
#pragma once

#include <cstdint>

namespace tessera::firmware::lm3s6965 {

/// Keeps to a fixed grid. A tick that was missed altogether is dropped, not made up for: two runs in a row would see
/// the same sensors twice and take the wheels for standing.
class TickSchedule {
public:
  TickSchedule(std::uint32_t nowMicros, std::uint32_t period) : next_{nowMicros + period}, period_{period} {}

  /// True once per period, on the first call at or after its beginning.
  bool due(std::uint32_t nowMicros) {
    const std::uint32_t late = nowMicros - next_;
    if (late > 0x7FFFFFFF) return false;
    next_ += (late / period_ + 1) * period_;
    return true;
  }

private:
  std::uint32_t next_;
  std::uint32_t period_;
};

}  // namespace tessera::firmware::lm3s6965
