// Giving a vehicle another long-term key over the air. The new key travels masked, under a session that the present key
// has opened; who knows neither the present key nor overhears the pairing with it learns and changes nothing.
// docs/decisions/0008-pairing.md says what this protects against and what not. Freestanding.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "wire/bytes.h"
#include "wire/messages.h"
#include "wire/security.h"

namespace tessera::wire {

/// With which a vehicle leaves the factory: 16 zero bytes. Everybody knows it, so it protects nothing: pair first.
inline constexpr Key kFactoryKey{};

/// What makes one Pair frame different from every other: its session, and its counter in it.
struct PairingNonce {
  SessionNonce session;
  std::uint32_t counter = 0;
  bool operator==(const PairingNonce&) const = default;
};

/// Body of Pair (session key). 24 bytes.
struct Pair {
  /// The new key, exclusive-or the first 16 bytes of HMAC-SHA-256(present key, "tessera pair mask" | nonce).
  Key masked{};
  /// First 8 bytes of HMAC-SHA-256(new key, "tessera pair proof" | nonce): the new key has arrived whole.
  std::array<std::uint8_t, 8> proof{};
  bool operator==(const Pair&) const = default;
};

/// Body of Paired (the long-term key that is in force when it is sent, counter 0). 9 bytes.
struct Paired {
  std::uint32_t hostNonce = 0;  ///< of the session in which the Pair came
  std::uint32_t ack = 0;        ///< counter of the Pair, all 32 bits
  Outcome outcome = Outcome::Done;
  bool operator==(const Paired&) const = default;
};

[[nodiscard]] Pair makePair(const Key& present, const Key& fresh, const PairingNonce& nonce);
/// The new key; nullopt when the proof does not fit.
[[nodiscard]] std::optional<Key> openPair(const Pair& pair, const Key& present, const PairingNonce& nonce);

std::size_t encode(const Pair& m, std::span<std::uint8_t> out);
std::size_t encode(const Paired& m, std::span<std::uint8_t> out);
[[nodiscard]] std::optional<Pair> decodePair(Bytes body);
[[nodiscard]] std::optional<Paired> decodePaired(Bytes body);

}  // namespace tessera::wire
