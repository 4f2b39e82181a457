// Where nonces come from: a generator that is handed in, so that a run can be repeated. A real run seeds it from a true
// random source. SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, OOPSLA 2014).
// A nonce needs to be new, not secret: the Hello that carries it is authenticated with the long-term key.
#pragma once

#include <cstdint>

namespace tessera::link {

class NonceSource {
public:
  explicit NonceSource(std::uint64_t seed) : state_{seed} {}
  [[nodiscard]] std::uint32_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15U);
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return static_cast<std::uint32_t>((z ^ (z >> 31U)) >> 32U);
  }

private:
  std::uint64_t state_;
};

}  // namespace tessera::link
