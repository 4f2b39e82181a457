// Random numbers by counter: the n-th number is a hash of n and a key, so that a filter is the same on every machine
// and every run, and no library's generator or clock comes in (SplitMix64: Steele, Lea, Flood, "Fast splittable
// pseudorandom number generators", OOPSLA 2014; the idea: Salmon et al., "Parallel random numbers: as easy as 1, 2, 3",
// SC 2011).
#pragma once

#include <cstdint>

namespace tessera::locate {

class CounterRandom {
public:
  explicit CounterRandom(std::uint64_t key) : key_{hash(key)} {}

  /// Even in [0, 1).
  [[nodiscard]] double uniform() { return static_cast<double>(next() >> 11U) * 0x1p-53; }
  /// Of mean 0 and deviation 1: the sum of four even numbers of 16 bits, which ends at 3.5 deviations; a filter's noise
  /// needs no longer tails, and the sum costs no logarithm.
  [[nodiscard]] double normal() {
    const std::uint64_t bits = next();
    const auto sum =
        static_cast<double>((bits & 0xFFFFU) + (bits >> 16U & 0xFFFFU) + (bits >> 32U & 0xFFFFU) + (bits >> 48U));
    return (sum - 131070.0) * kPerDeviation;
  }

private:
  static constexpr double kPerDeviation = 2.642895e-5;  // √3 / 65536

  [[nodiscard]] std::uint64_t next() { return hash(key_ + ++count_ * 0x9E3779B97F4A7C15ULL); }
  [[nodiscard]] static constexpr std::uint64_t hash(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
  }

  std::uint64_t key_;
  std::uint64_t count_ = 0;
};

}  // namespace tessera::locate
