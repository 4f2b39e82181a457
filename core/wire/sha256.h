// SHA-256 (FIPS 180-4) and HMAC-SHA-256 (RFC 2104), small enough for a microcontroller.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "wire/bytes.h"

namespace tessera::wire {

using Digest = std::array<std::uint8_t, 32>;

class Sha256 {
public:
  void update(Bytes data);
  [[nodiscard]] Digest finish();

private:
  void compress();

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::uint8_t, 64> block_{};
  std::size_t fill_ = 0;
  std::uint64_t length_ = 0;
};

/// HMAC-SHA-256 fed in pieces. Keys longer than 64 bytes are hashed first, as RFC 2104 asks.
class Hmac {
public:
  explicit Hmac(Bytes key);
  void update(Bytes data) { inner_.update(data); }
  [[nodiscard]] Digest finish();

private:
  Sha256 inner_;
  Sha256 outer_;
};

}  // namespace tessera::wire
