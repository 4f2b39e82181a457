// Measures the echo pulse of an HC-SR04: its length is the time that sound needs to the obstacle and back.
#pragma once

#include <atomic>
#include <cstdint>

namespace tessera::firmware::lm3s6965 {

/// edge() is called from an interrupt handler, the rest from the main loop with that interrupt held off or idle.
class EchoTimer {
public:
  /// A new measurement begins: an echo that is still under way belongs to the last one and is forgotten.
  void begin() {
    rising_ = false;
    length_.store(0, std::memory_order_relaxed);
  }
  void edge(bool high, std::uint32_t nowMicros) {
    if (high) {
      start_ = nowMicros;
      rising_ = true;
    } else if (rising_) {
      rising_ = false;
      const std::uint32_t length = nowMicros - start_;
      length_.store(length == 0 ? 1 : length, std::memory_order_relaxed);
    }
  }
  /// µs; 0 while none has come since begin().
  [[nodiscard]] std::uint32_t length() const { return length_.load(std::memory_order_relaxed); }

private:
  std::atomic<std::uint32_t> length_{0};
  std::uint32_t start_ = 0;
  bool rising_ = false;
};

}  // namespace tessera::firmware::lm3s6965
