#include "link/session.h"

#include <array>

namespace tessera::link {

std::size_t Session::hello(std::uint32_t nonce, std::uint32_t hostCounter, std::span<std::uint8_t> out) {
  nonce_ = nonce;
  callsOffered_ = offered_ && !callsOffered_;
  std::array<std::uint8_t, 8> body{};
  const std::size_t size = wire::encode(wire::Hello{nonce, hostCounter}, body);
  const wire::FrameHeader header{vehicle_.value, wire::kHostAddress,
                                 static_cast<std::uint8_t>(wire::MessageType::Hello), 0};
  return wire::sealFrame(callsOffered_ ? *offered_ : longTerm_, 0, header, wire::Bytes{body}.first(size), out);
}

std::size_t Session::request(const wire::Request& request, std::uint32_t counter, std::span<std::uint8_t> out) const {
  if (!session_) return 0;
  std::array<std::uint8_t, 8> body{};
  const std::size_t size = wire::encode(request, body);
  const wire::FrameHeader header{vehicle_.value, wire::kHostAddress, static_cast<std::uint8_t>(request.type), 0};
  return wire::sealFrame(session_->key, counter, header, wire::Bytes{body}.first(size), out);
}

// Frames under the long-term key carry the counter 0.
bool Session::genuine(const wire::Key& key, const wire::Frame& frame, const wire::Sealed& sealed) const {
  return frame.header.counter == 0 && wire::sameMac(wire::macOf(key, 0, frame.header, sealed.body), sealed.mac);
}

Heard Session::hearIdentity(const wire::Sealed& sealed, bool underOffered) {
  const auto heard = wire::decodeIdentity(sealed.body);
  if (!heard) return Disbelief::Strange;
  // Each nonce is new, so an answer to another one is an old answer.
  if (session_ && !nonce_) return Disbelief::Replayed;
  if (!nonce_ || heard->hostNonce != *nonce_) return HeardLate{heard->hostNonce};
  nonce_.reset();
  if (underOffered) adoptOffered();
  if (heard->protocol != wire::kProtocolVersion) {
    session_.reset();
    return HeardVersion{heard->protocol};
  }
  // A vehicle whose EEPROM is dead repeats its start counter, but then counts its Hellos from the beginning.
  const bool restarted = identity_ && (heard->boot != identity_->boot || heard->hello <= identity_->hello);
  const bool first = !identity_;
  identity_ = *heard;
  session_ =
      Open{wire::deriveSessionKey(longTerm_, {heard->hostNonce, heard->boot, heard->hello}), wire::ReplayGuard{}};
  return HeardIdentity{*heard, first, restarted};
}

Heard Session::hearHail(const wire::Sealed& sealed, bool underOffered) {
  const auto hail = wire::decodeHail(sealed.body);
  if (!hail) return Disbelief::Strange;
  if (underOffered) {
    // Nobody but the vehicle has this key; still only its Identity proves that it has it now. It is called with it
    // next.
    callsOffered_ = false;
    session_.reset();
    return HeardHail{*hail, false};
  }
  // While a session stands only a later start explains a Hail; an old one could be a recording. A vehicle that cannot
  // count its starts is called again all the same, a little later: its reports stay away.
  // And a session in which nothing was ever said may not have come about on the other side.
  const bool restarted = identity_ && hail->boot > identity_->boot;
  const bool untried = session_ && session_->guard.last() == 0 && hail->boot == identity_->boot;
  if (session_ && !restarted && !untried) return Disbelief::Replayed;
  session_.reset();
  return HeardHail{*hail, restarted};
}

Heard Session::hear(const wire::Frame& frame) {
  const auto sealed = wire::splitMac(frame.payload);
  if (!sealed) return Disbelief::Strange;
  const auto type = static_cast<wire::MessageType>(frame.header.type);
  if (type == wire::MessageType::Identity || type == wire::MessageType::Hail || type == wire::MessageType::Paired) {
    const bool underOffered = offered_ && genuine(*offered_, frame, *sealed);
    if (!underOffered && !genuine(longTerm_, frame, *sealed)) return session_ ? Disbelief::Forged : Disbelief::WrongKey;
    if (type == wire::MessageType::Paired) return hearPaired(*sealed, underOffered);
    return type == wire::MessageType::Identity ? hearIdentity(*sealed, underOffered) : hearHail(*sealed, underOffered);
  }
  if (type != wire::MessageType::Report && type != wire::MessageType::Value) return Disbelief::Strange;
  if (!session_) return Disbelief::Stale;
  switch (session_->guard.accept(session_->key, frame.header, sealed->body, sealed->mac)) {
    case wire::Refusal::None:
      break;
    case wire::Refusal::Replayed:
      return Disbelief::Replayed;
    case wire::Refusal::TooShort:
    case wire::Refusal::Forged:
      return Disbelief::Forged;
  }
  nonce_.reset();  // it lives on in the standing session: the call in between was not heard
  if (type == wire::MessageType::Report) {
    const auto report = wire::decodeReport(sealed->body);
    if (report) heardAnswerTo(report->ack);
    if (report) return HeardReport{*report};
  } else if (const auto value = wire::decodeValue(sealed->body)) {
    heardAnswerTo(value->ack);
    return HeardValue{*value};
  }
  return Disbelief::Strange;
}

}  // namespace tessera::link
