// Time on the vehicle: microseconds since its start, which unlike the board's counter never wrap.
#pragma once

#include <chrono>
#include <cstdint>

namespace tessera::firmware {

using Micros = std::chrono::duration<std::int64_t, std::micro>;
using namespace std::chrono_literals;

inline constexpr Micros kTickPeriod = 10ms;
inline constexpr float kTickSeconds = 0.01F;

class Clock {
public:
  /// The board's counter as it stands now; to be called at least once in 71 minutes.
  Micros update(std::uint32_t counter) {
    now_ += Micros{static_cast<std::uint32_t>(counter - last_)};
    last_ = counter;
    return now_;
  }
  [[nodiscard]] Micros now() const { return now_; }

private:
  Micros now_{0};
  std::uint32_t last_ = 0;
};

}  // namespace tessera::firmware
