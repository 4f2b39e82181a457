// Taking another long-term key: which Pair frames are believed, and what becomes of the sessions.
#include "firmware/vehicle/session.h"

namespace tessera::firmware {
namespace {

constexpr Micros kPairedPatience = 100ms;

}  // namespace

Heard Session::receivePair(const wire::Frame& frame, Micros now) {
  const auto sealed = wire::splitMac(frame.payload);
  if (!sealed || frame.header.to != person_.address) return {};
  const auto pair = wire::decodePair(sealed->body);
  Heard heard;
  if (!pair) return {};
  const Keyed* const session = authenticPair(frame.header, *sealed, heard);
  if (session == nullptr) return {};
  const bool again = former_ && session == &*former_;
  const wire::PairingNonce nonce{{session->hostNonce, boot(), session->hello}, session->guard.last()};
  const auto key = wire::openPair(*pair, again ? formerKey_ : person_.key, nonce);
  // The former session may only hear once more what it has brought about: its key is the former one's child.
  if (again && key != person_.key) return heard;
  heard.pairing = {session->hostNonce, session->guard.last(), wire::Outcome::Done};
  if (!key) {
    if (pairing_) return heard;
    pairingBegun(heard.pairing);
    pairingEnded(wire::Outcome::OutOfRange, now);
    return heard;
  }
  heard.kind = Heard::Kind::Pair;
  heard.newKey = *key;
  return heard;
}

Session::Keyed* Session::authenticPair(const wire::FrameHeader& header, const wire::Sealed& sealed, Heard& heard) {
  if (former_ && former_->guard.accept(former_->key, header, sealed.body, sealed.mac) == wire::Refusal::None)
    return &*former_;
  return authentic(header, sealed.body, sealed.mac, heard) ? &*current_ : nullptr;
}

void Session::pairingBegun(const wire::Paired& pairing) {
  pairing_ = true;
  paired_ = pairing;
}

void Session::rekey(const wire::Key& key) {
  former_ = current_;
  formerKey_ = person_.key;
  current_.reset();
  pending_.reset();
  person_.key = key;
}

void Session::pairingEnded(wire::Outcome outcome, Micros now) {
  pairing_ = false;
  paired_.outcome = outcome;
  owe(Owed::Paired, now, kPairedPatience);
}

std::size_t Session::writePaired(std::span<std::uint8_t> out) {
  owed_ = Owed::Nothing;
  std::array<std::uint8_t, wire::kMaxPayload> body{};
  return sealLongTerm(wire::MessageType::Paired, wire::Bytes{body}.first(encode(paired_, body)), out);
}

}  // namespace tessera::firmware
