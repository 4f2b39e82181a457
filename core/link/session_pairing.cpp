// Giving the vehicle another key: what proves which key it has.
#include <array>

#include "link/session.h"

namespace tessera::link {

std::size_t Session::pair(const wire::Key& fresh, std::uint32_t counter, std::span<std::uint8_t> out) {
  if (!session_ || !identity_) return 0;
  offered_ = fresh;
  givenUp_ = false;
  mayHaveEither_ = false;
  pairCounter_ = counter;
  pairNonce_ = identity_->hostNonce;
  const wire::PairingNonce nonce{{identity_->hostNonce, identity_->boot, identity_->hello}, counter};
  std::array<std::uint8_t, wire::kMaxPayload> body{};
  const std::size_t size = wire::encode(wire::makePair(longTerm_, fresh, nonce), body);
  const wire::FrameHeader header{vehicle_.value, wire::kHostAddress, static_cast<std::uint8_t>(wire::MessageType::Pair),
                                 0};
  return wire::sealFrame(session_->key, counter, header, wire::Bytes{body}.first(size), out);
}

void Session::adoptOffered() {
  longTerm_ = *offered_;
  offered_.reset();
  mayHaveEither_ = false;
  session_.reset();
  pairingEnd_ = PairingEnd::NewKey;
}

Heard Session::hearPaired(const wire::Sealed& sealed, bool underOffered) {
  const auto paired = wire::decodePaired(sealed.body);
  if (!paired) return Disbelief::Strange;
  // An answer to an earlier try under the new key is as good as one to the last; a refusal is not, as the last may have
  // been taken since.
  const bool mine = pairNonce_ && paired->hostNonce == *pairNonce_ && paired->ack <= *pairCounter_;
  if (!offered_ || !mine) return offered_ ? Disbelief::Replayed : Disbelief::Stale;
  if (underOffered && paired->outcome == wire::Outcome::Done) {
    adoptOffered();
    return HeardPaired{paired->outcome};
  }
  if (underOffered || paired->ack != pairCounter_) return Disbelief::Stale;
  switch (paired->outcome) {
    case wire::Outcome::Busy:
      pairingEnd_ = PairingEnd::Busy;
      break;
    case wire::Outcome::OutOfRange:
      pairingEnd_ = PairingEnd::Garbled;
      break;
    case wire::Outcome::Failed:
      pairingEnd_ = PairingEnd::Failed;
      mayHaveEither_ = true;
      givenUp_ = true;
      return HeardPaired{paired->outcome};
    default:
      return Disbelief::Strange;
  }
  offered_.reset();
  return HeardPaired{paired->outcome};
}

// A vehicle that answers a frame later than the last Pair, in a session under the old key, has passed that Pair over,
// and its counter keeps it from taking it any more.
void Session::heardAnswerTo(std::uint16_t ack) {
  if (!offered_ || !givenUp_ || mayHaveEither_) return;
  if (pairCounter_ && static_cast<std::int16_t>(ack - static_cast<std::uint16_t>(*pairCounter_)) <= 0) return;
  offered_.reset();
  pairingEnd_ = PairingEnd::OldKey;
}

}  // namespace tessera::link
