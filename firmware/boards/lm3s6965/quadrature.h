// Counts the edges of a wheel encoder's two channels, which stand a quarter period apart.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace tessera::firmware::lm3s6965 {

/// Fed with the channels' levels (A | B << 1) after an edge, from an interrupt handler; read from the main loop.
/// Forwards is 00, A, AB, B, 00: four counts a period. Levels that skip one quarter tell no direction and count
/// nothing.
class Quadrature {
public:
  explicit Quadrature(std::uint32_t levels = 0) : levels_{levels & 3U} {}

  void see(std::uint32_t levels) {
    static constexpr std::array<std::int8_t, 16> kStep = {0, +1, -1, 0, -1, 0, 0, +1, +1, 0, 0, -1, 0, -1, +1, 0};
    levels &= 3U;
    const std::int32_t step = kStep[levels_ << 2 | levels];
    if (step == 0 && levels != levels_) skipped_.store(skipped_.load(kRelaxed) + 1, kRelaxed);
    levels_ = levels;
    // Unsigned inside, so that the count wraps instead of overflowing.
    count_.store(count_.load(kRelaxed) + static_cast<std::uint32_t>(step), kRelaxed);
  }
  /// Takes levels as they are, without counting.
  void start(std::uint32_t levels) { levels_ = levels & 3U; }

  [[nodiscard]] std::int32_t count() const { return static_cast<std::int32_t>(count_.load(kRelaxed)); }
  /// How often both channels had changed at once: edges came faster than they were looked at.
  [[nodiscard]] std::uint32_t skipped() const { return skipped_.load(kRelaxed); }

private:
  static constexpr auto kRelaxed = std::memory_order_relaxed;
  std::uint32_t levels_;
  std::atomic<std::uint32_t> count_{0};
  std::atomic<std::uint32_t> skipped_{0};
};

}  // namespace tessera::firmware::lm3s6965
