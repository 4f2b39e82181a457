#include "wire/security.h"

#include <algorithm>
#include <string_view>

#include "wire/sha256.h"

namespace tessera::wire {

Key deriveSessionKey(const Key& longTerm, const SessionNonce& nonce) {
  constexpr std::string_view label = "tessera session";
  std::array<std::uint8_t, label.size() + 10> text{};
  ByteWriter w{text};
  for (char c : label) w.u8(static_cast<std::uint8_t>(c));
  w.u32(nonce.host);
  w.u32(nonce.boot);
  w.u16(nonce.hello);
  Hmac hmac{longTerm};
  hmac.update(w.written());
  const Digest digest = hmac.finish();
  Key key;
  std::copy_n(digest.begin(), key.size(), key.begin());
  return key;
}

Mac macOf(const Key& key, std::uint32_t counter, const FrameHeader& header, Bytes body) {
  std::array<std::uint8_t, 7> prefix{};
  ByteWriter w{prefix};
  w.u32(counter);
  w.u8(header.to);
  w.u8(header.from);
  w.u8(header.type);
  Hmac hmac{key};
  hmac.update(w.written());
  hmac.update(body);
  const Digest digest = hmac.finish();
  Mac mac;
  std::copy_n(digest.begin(), mac.size(), mac.begin());
  return mac;
}

bool sameMac(const Mac& a, Bytes b) {
  if (b.size() != a.size()) return false;
  // No early exit: the time taken tells nothing about how much was right.
  std::uint8_t difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference = static_cast<std::uint8_t>(difference | (a[i] ^ b[i]));
  return difference == 0;
}

std::size_t sealFrame(const Key& key, std::uint32_t counter, FrameHeader header, Bytes body,
                      std::span<std::uint8_t> out) {
  header.counter = static_cast<std::uint16_t>(counter);
  std::array<std::uint8_t, kMaxPayload> payload{};
  ByteWriter w{payload};
  w.bytes(body);
  w.bytes(macOf(key, counter, header, body));
  if (w.overrun()) return 0;
  return encodeFrame(header, w.written(), out);
}

std::uint32_t ReplayGuard::expand(std::uint16_t low) const {
  const std::uint32_t same = (last_ & 0xFFFF0000U) | low;
  return same > last_ ? same : same + 0x10000U;
}

Refusal ReplayGuard::accept(const Key& key, const FrameHeader& header, Bytes body, Bytes mac) {
  if (mac.size() != Mac{}.size()) return Refusal::TooShort;
  const std::uint32_t counter = expand(header.counter);
  if (sameMac(macOf(key, counter, header, body), mac)) {
    last_ = counter;
    return Refusal::None;
  }
  // Telling an old frame from a damaged one costs a second look but gives the operator the right sentence.
  if (counter >= 0x10000U && sameMac(macOf(key, counter - 0x10000U, header, body), mac)) return Refusal::Replayed;
  return Refusal::Forged;
}

std::optional<Sealed> splitMac(Bytes payload) {
  constexpr std::size_t macSize = Mac{}.size();
  if (payload.size() < macSize) return std::nullopt;
  return Sealed{payload.first(payload.size() - macSize), payload.last(macSize)};
}

}  // namespace tessera::wire
