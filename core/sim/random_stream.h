// Chance in the simulated world: each part draws from a stream of its own, so that a change in one part (a faster
// reader, say) leaves the draws of all others as they were and runs with the same seed stay comparable.
#pragma once

#include <cstdint>
#include <random>
#include <string_view>

namespace tessera::sim {

class RandomStream {
public:
  /// `part` names what draws, `index` which one of several (a vehicle's address, a reader's number).
  RandomStream(std::uint64_t seed, std::string_view part, std::uint64_t index = 0)
      : engine_{mixed(mixed(seed) ^ mixed(hashed(part)) ^ mixed(index + 0x51ed2701ULL))} {}

  /// In [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * uniform(); }
  double normal(double sigma) { return sigma * normal_(engine_); }
  bool chance(double probability) { return uniform() < probability; }

private:
  /// The finaliser of SplitMix64 (Steele, Lea, Flood, OOPSLA 2014).
  static std::uint64_t mixed(std::uint64_t v) {
    v += 0x9e3779b97f4a7c15ULL;
    v = (v ^ (v >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    v = (v ^ (v >> 27U)) * 0x94d049bb133111ebULL;
    return v ^ (v >> 31U);
  }
  /// FNV-1a, 64 bits.
  static std::uint64_t hashed(std::string_view text) {
    std::uint64_t h = 0xcbf29ce484222325ULL;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return h;
  }

  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
};

}  // namespace tessera::sim
