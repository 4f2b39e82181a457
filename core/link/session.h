// The host's side of the meeting with one vehicle: who it is, which key holds now, which of its frames to believe.
// Knows no time and sends nothing by itself: it writes frames into buffers and says what a received frame means.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "base/ids.h"
#include "wire/messages.h"
#include "wire/pairing.h"
#include "wire/security.h"

namespace tessera::link {

enum class Disbelief : std::uint8_t {
  WrongKey,  ///< it answers a call, but not with the key that this host has for it
  Forged,    ///< its MAC fits nothing while a session stands
  Replayed,  ///< genuine, but seen before in this session, or of an earlier meeting
  Stale,     ///< of a session or a pairing that is over; harmless
  Strange,   ///< well authenticated or too short to be, and makes no sense
};

struct HeardIdentity {
  wire::Identity identity;
  bool first = false;      ///< the first session with it at all
  bool restarted = false;  ///< it has started anew since the last session
};
/// A genuine answer to a call that has been repeated since. It opens nothing: the vehicle keeps only the session that
/// the last call has prepared, and the answer may be a recording. But it tells how long a call and its answer take.
struct HeardLate {
  std::uint32_t hostNonce = 0;
};
struct HeardVersion {  ///< genuine, but of another version of the protocol: no session
  std::uint8_t protocol = 0;
};
struct HeardHail {  ///< it has no session with us
  wire::Hail hail;
  bool restarted = false;
};
struct HeardReport {
  wire::Report report;
};
struct HeardValue {
  wire::Value value;
};
struct HeardPaired {  ///< genuine, under the key that the vehicle has now
  wire::Outcome outcome = wire::Outcome::Done;
};
using Heard =
    std::variant<Disbelief, HeardIdentity, HeardLate, HeardVersion, HeardHail, HeardReport, HeardValue, HeardPaired>;

/// How the giving of another key to the vehicle has ended.
enum class PairingEnd : std::uint8_t {
  NewKey,   ///< it has proved that it has the new key, with which it is called from now on
  OldKey,   ///< it has proved that it heard nothing of it, and never will
  Busy,     ///< it refused, as it drives
  Garbled,  ///< it refused, as the key did not arrive whole
  Failed,   ///< it could not keep the key; after its next start it may have either, so that both are tried
  Unknown,  ///< no answer: it may have either, both are tried until one is proved. Not an end: another one follows
};

class Session {
public:
  /// offered: another key that it may have by now, from a pairing whose end was never heard.
  Session(VehicleId vehicle, const wire::Key& longTerm, const std::optional<wire::Key>& offered = {})
      : vehicle_{vehicle}, longTerm_{longTerm}, offered_{offered}, givenUp_{offered.has_value()} {}

  [[nodiscard]] VehicleId vehicle() const { return vehicle_; }
  /// A session stands. It may still be dead on the other side, which answers with a Hail or not at all.
  [[nodiscard]] bool open() const { return session_.has_value(); }
  [[nodiscard]] const std::optional<wire::Identity>& identity() const { return identity_; }
  /// The key of the standing session; the long-term key when there is none, so that a probing Cycle entry can be made,
  /// which a vehicle without a session answers with a Hail.
  [[nodiscard]] const wire::Key& key() const { return session_ ? session_->key : longTerm_; }

  /// Writes a call; returns its size. hostCounter: the last counter used on this channel. A standing session is kept
  /// until the call is answered.
  std::size_t hello(std::uint32_t nonce, std::uint32_t hostCounter, std::span<std::uint8_t> out);
  /// Writes a request under `counter`, which must be above every counter used before. Requires open().
  [[nodiscard]] std::size_t request(const wire::Request& request, std::uint32_t counter,
                                    std::span<std::uint8_t> out) const;
  /// Writes a Pair, offering this key, under `counter`. May be repeated until takePairingEnd() tells the end. Requires
  /// open().
  [[nodiscard]] std::size_t pair(const wire::Key& fresh, std::uint32_t counter, std::span<std::uint8_t> out);
  /// No further pair() follows: what the vehicle says from now on tells which key it has.
  void pairingGivenUp() { givenUp_ = true; }
  /// Told once. Nullopt: no pairing, or not ended.
  [[nodiscard]] std::optional<PairingEnd> takePairingEnd() { return std::exchange(pairingEnd_, std::nullopt); }
  /// A key was offered and may be in force: calls go with it and with the present one in turn.
  [[nodiscard]] bool pairing() const { return offered_.has_value(); }
  /// The key with which the vehicle is believed now.
  [[nodiscard]] const wire::Key& longTermKey() const { return longTerm_; }
  /// What a frame with this vehicle's address in `from` means. Believed frames count as seen.
  Heard hear(const wire::Frame& frame);

private:
  struct Open {
    wire::Key key{};
    wire::ReplayGuard guard;
  };
  Heard hearIdentity(const wire::Sealed& sealed, bool underOffered);
  Heard hearHail(const wire::Sealed& sealed, bool underOffered);
  Heard hearPaired(const wire::Sealed& sealed, bool underOffered);
  [[nodiscard]] bool genuine(const wire::Key& key, const wire::Frame& frame, const wire::Sealed& sealed) const;
  void adoptOffered();
  void heardAnswerTo(std::uint16_t ack);

  VehicleId vehicle_;
  wire::Key longTerm_;
  std::optional<std::uint32_t> nonce_;  ///< of the call that is not answered yet
  std::optional<wire::Key> offered_;
  bool givenUp_ = false;
  bool callsOffered_ = false;                 ///< the call that is not answered yet went with the offered key
  std::optional<std::uint32_t> pairCounter_;  ///< of the last Pair; nullopt: it went before this host was started
  std::optional<std::uint32_t> pairNonce_;    ///< host's nonce of the session in which it went
  std::optional<PairingEnd> pairingEnd_;
  bool mayHaveEither_ = false;  ///< it failed to keep the offered key
  std::optional<wire::Identity> identity_;
  std::optional<Open> session_;
};

}  // namespace tessera::link
