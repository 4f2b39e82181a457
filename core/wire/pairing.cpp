#include "wire/pairing.h"

#include <algorithm>
#include <string_view>

#include "wire/sha256.h"

namespace tessera::wire {
namespace {

Digest digestOf(const Key& key, std::string_view label, const PairingNonce& nonce) {
  std::array<std::uint8_t, 32> text{};
  ByteWriter w{text};
  for (char c : label) w.u8(static_cast<std::uint8_t>(c));
  w.u32(nonce.session.host);
  w.u32(nonce.session.boot);
  w.u16(nonce.session.hello);
  w.u32(nonce.counter);
  Hmac hmac{key};
  hmac.update(w.written());
  return hmac.finish();
}

Key masked(const Key& key, const Key& present, const PairingNonce& nonce) {
  const Digest mask = digestOf(present, "tessera pair mask", nonce);
  Key out;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<std::uint8_t>(key[i] ^ mask[i]);
  return out;
}

std::array<std::uint8_t, 8> proofOf(const Key& fresh, const PairingNonce& nonce) {
  const Digest digest = digestOf(fresh, "tessera pair proof", nonce);
  std::array<std::uint8_t, 8> proof;
  std::copy_n(digest.begin(), proof.size(), proof.begin());
  return proof;
}

}  // namespace

Pair makePair(const Key& present, const Key& fresh, const PairingNonce& nonce) {
  return {masked(fresh, present, nonce), proofOf(fresh, nonce)};
}

std::optional<Key> openPair(const Pair& pair, const Key& present, const PairingNonce& nonce) {
  const Key fresh = masked(pair.masked, present, nonce);
  if (proofOf(fresh, nonce) != pair.proof) return std::nullopt;
  return fresh;
}

std::size_t encode(const Pair& m, std::span<std::uint8_t> out) {
  ByteWriter w{out};
  w.bytes(m.masked);
  w.bytes(m.proof);
  return w.overrun() ? 0 : w.size();
}

std::size_t encode(const Paired& m, std::span<std::uint8_t> out) {
  ByteWriter w{out};
  w.u32(m.hostNonce);
  w.u32(m.ack);
  w.u8(static_cast<std::uint8_t>(m.outcome));
  return w.overrun() ? 0 : w.size();
}

std::optional<Pair> decodePair(Bytes body) {
  Pair m;
  if (body.size() != m.masked.size() + m.proof.size()) return std::nullopt;
  std::copy_n(body.begin(), m.masked.size(), m.masked.begin());
  std::copy_n(body.begin() + static_cast<std::ptrdiff_t>(m.masked.size()), m.proof.size(), m.proof.begin());
  return m;
}

std::optional<Paired> decodePaired(Bytes body) {
  ByteReader r{body};
  Paired m;
  m.hostNonce = r.u32();
  m.ack = r.u32();
  const std::uint8_t outcome = r.u8();
  if (r.overrun() || r.remaining() > 0 || outcome > static_cast<std::uint8_t>(Outcome::Failed)) return std::nullopt;
  m.outcome = static_cast<Outcome>(outcome);
  return m;
}

}  // namespace tessera::wire
