// A number that is unlikely to come twice, gathered from the timing of outside events, for a vehicle whose EEPROM
// cannot count its starts. Weaker than a counter: the fault kFaultEeprom tells the operator so.
#pragma once

#include <cstdint>

#include "wire/sha256.h"

namespace tessera::firmware {

class Entropy {
public:
  /// Adds whatever varies from start to start: arrival times in µs, the last bits of a sensor.
  void stir(std::uint32_t v) {
    for (int i = 0; i < 4; ++i) {
      pool_ = (pool_ ^ (v & 0xFFU)) * 16777619U;  // FNV-1a, so that the order of events counts too
      v >>= 8;
    }
    ++stirred_;
  }
  /// All that was stirred in, mixed; the highest bit is set, which no counted start reaches.
  [[nodiscard]] std::uint32_t number() const {
    wire::Sha256 sha;
    const std::uint8_t bytes[8] = {
        static_cast<std::uint8_t>(pool_),          static_cast<std::uint8_t>(pool_ >> 8),
        static_cast<std::uint8_t>(pool_ >> 16),    static_cast<std::uint8_t>(pool_ >> 24),
        static_cast<std::uint8_t>(stirred_),       static_cast<std::uint8_t>(stirred_ >> 8),
        static_cast<std::uint8_t>(stirred_ >> 16), static_cast<std::uint8_t>(stirred_ >> 24)};
    sha.update(bytes);
    const wire::Digest d = sha.finish();
    return 0x80000000U | (std::uint32_t{d[0]} << 24) | (std::uint32_t{d[1]} << 16) | (std::uint32_t{d[2]} << 8) | d[3];
  }

private:
  std::uint32_t pool_ = 2166136261U;
  std::uint32_t stirred_ = 0;
};

}  // namespace tessera::firmware
