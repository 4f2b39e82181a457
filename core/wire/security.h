// Who may speak: per-vehicle keys, a session for every meeting of host and vehicle, counters against replay.
//
// Each vehicle shares one long-term key with its host. Hello and Identity exchange a nonce of the host and the
// vehicle's start counter, both fresh, from which both sides derive a session key. Every further frame is
// authenticated with the session key and carries a counter that only grows; a frame recorded in another session or
// earlier in this one is refused. The tag is HMAC-SHA-256 cut to four bytes: short, because a radio packet holds 58.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "wire/bytes.h"
#include "wire/frame.h"

namespace tessera::wire {

using Key = std::array<std::uint8_t, 16>;
using Mac = std::array<std::uint8_t, 4>;

/// What makes one session different from every other of the same vehicle.
struct SessionNonce {
  std::uint32_t host = 0;   ///< random, chosen by the host for each Hello
  std::uint32_t boot = 0;   ///< counted in the vehicle's EEPROM at each start
  std::uint16_t hello = 0;  ///< counted by the vehicle for each Hello since its start
  bool operator==(const SessionNonce&) const = default;
};

/// First 16 bytes of HMAC-SHA-256(longTerm, "tessera session" | host u32 | boot u32 | hello u16).
[[nodiscard]] Key deriveSessionKey(const Key& longTerm, const SessionNonce& nonce);

/// First 4 bytes of HMAC-SHA-256(key, counter u32 | to | from | type | body).
[[nodiscard]] Mac macOf(const Key& key, std::uint32_t counter, const FrameHeader& header, Bytes body);
[[nodiscard]] bool sameMac(const Mac& a, Bytes b);

/// Encodes a frame whose payload is `body` followed by its MAC. Returns its size, 0 when it does not fit.
[[nodiscard]] std::size_t sealFrame(const Key& key, std::uint32_t counter, FrameHeader header, Bytes body,
                                    std::span<std::uint8_t> out);

enum class Refusal : std::uint8_t {
  None,
  TooShort,  ///< no room for a MAC
  Forged,    ///< no counter makes the MAC fit: wrong key, other session, or changed bytes
  Replayed,  ///< genuine, but already seen in this session
};

/// The receiving side of one session: accepts each counter once, in growing order.
class ReplayGuard {
public:
  explicit ReplayGuard(std::uint32_t last = 0) : last_{last} {}
  /// The 32-bit counter that the low 16 bits stand for: the next one above the last accepted.
  [[nodiscard]] std::uint32_t expand(std::uint16_t low) const;
  /// Checks `mac` for header and body. On Refusal::None the counter counts as seen.
  Refusal accept(const Key& key, const FrameHeader& header, Bytes body, Bytes mac);
  [[nodiscard]] std::uint32_t last() const { return last_; }

private:
  std::uint32_t last_;
};

/// The last four bytes of a payload are its MAC; what stands before is the body. Nullopt when there are fewer.
struct Sealed {
  Bytes body;
  Bytes mac;
};
[[nodiscard]] std::optional<Sealed> splitMac(Bytes payload);

}  // namespace tessera::wire
