// The vehicle's side of the conversation with its host: who may command it, what it owes an answer to, and when.
// Frames go in, frames come out; the radio is not known here.
#pragma once

#include <cstdint>
#include <optional>

#include "firmware/vehicle/entropy.h"
#include "firmware/vehicle/time.h"
#include "wire/messages.h"
#include "wire/pairing.h"

namespace tessera::firmware {

/// What a received frame asks of the vehicle. Only genuine, fresh requests get this far.
struct Heard {
  enum class Kind : std::uint8_t { Nothing, Entry, Request, Pair };
  Kind kind = Kind::Nothing;
  bool newSession = false;  ///< the first frame of a session
  wire::CycleEntry entry;
  wire::Request request;
  wire::Key newKey{};    ///< Pair
  wire::Paired pairing;  ///< Pair: what its answer refers to
};

/// An answer that is due now.
enum class Owed : std::uint8_t { Nothing, Identity, Hail, Report, Value, Paired };

struct Person {
  std::uint8_t address = 0;
  wire::Key key{};
  std::uint32_t starts = 0;  ///< the start counter; 0: choose a number from timing when first asked
  wire::ResetCause cause = wire::ResetCause::PowerOn;
  std::uint8_t hardware = 255;
  std::uint8_t readers = 0;
  std::uint8_t rangers = 0;
};

class Session {
public:
  void start(const Person& person) { person_ = person; }

  /// `now`: when the frame's last byte came.
  Heard receive(const wire::Frame& frame, Micros now);
  /// Adds chance to the number that stands for the start when starts are not counted.
  void stir(std::uint32_t v) { entropy_.stir(v); }

  /// What is to be sent now. Answers to a Cycle wait for their slot; one that has missed it is dropped, as it would
  /// meet the next vehicle's.
  Owed due(Micros now);
  /// Make the frame that is owed and consider it sent; they return its size.
  std::size_t writeIdentity(std::span<std::uint8_t> out);
  std::size_t writeHail(std::span<std::uint8_t> out);
  std::size_t writeReport(wire::Report report, Micros now, std::span<std::uint8_t> out);  ///< fills in ack and hold
  std::size_t writeValue(std::span<std::uint8_t> out);
  std::size_t writePaired(std::span<std::uint8_t> out);
  /// The answer to the request that was heard last.
  void answer(wire::Outcome outcome, std::int32_t value);

  /// The key of a Pair is being kept: until it is answered nothing else is listened to, so that no other answer can
  /// make the host believe that the Pair was not heard. pairing: of the newest Pair that brought this key.
  void pairingBegun(const wire::Paired& pairing);
  /// The vehicle's key is another one from now on: no session made under the former one is worth anything any more.
  void rekey(const wire::Key& key);
  /// The answer to the Pair that has begun, under the key that is in force now.
  void pairingEnded(wire::Outcome outcome, Micros now);

  [[nodiscard]] bool open() const { return current_.has_value(); }
  /// kFaultForged and kFaultReplayed as they stand; writeReport() clears them.
  [[nodiscard]] std::uint16_t faults() const { return faults_; }
  [[nodiscard]] std::uint32_t framesRefused() const { return refused_; }

private:
  struct Keyed {
    wire::Key key{};
    wire::ReplayGuard guard;
    std::uint32_t hostNonce = 0;
    std::uint16_t hello = 0;
    std::uint32_t sent = 0;  ///< counter of the last frame sent
  };
  void receiveHello(const wire::Frame& frame, Micros now);
  Heard receiveCycle(const wire::Frame& frame, Micros now);
  Heard receiveRequest(const wire::Frame& frame, Micros now);
  Heard receivePair(const wire::Frame& frame, Micros now);
  [[nodiscard]] Keyed* authenticPair(const wire::FrameHeader& header, const wire::Sealed& sealed, Heard& heard);
  bool authentic(const wire::FrameHeader& header, wire::Bytes body, wire::Bytes mac, Heard& heard);
  void refuse(wire::Refusal why);
  void owe(Owed what, Micros when, Micros patience);
  std::uint32_t boot();
  std::size_t seal(wire::MessageType type, wire::Bytes body, std::span<std::uint8_t> out);
  std::size_t sealLongTerm(wire::MessageType type, wire::Bytes body, std::span<std::uint8_t> out) const;

  Person person_;
  Entropy entropy_;
  std::optional<Keyed> current_;
  std::optional<Keyed> pending_;
  std::optional<Keyed> former_;  ///< in which the key was changed: good for the same Pair once more, and nothing else
  wire::Key formerKey_{};        ///< the long-term key of that session
  bool pairing_ = false;
  wire::Paired paired_;
  std::uint16_t hellos_ = 0;
  std::uint16_t faults_ = 0;
  std::uint32_t refused_ = 0;
  std::uint16_t ack_ = 0;
  Micros ackTime_{0};
  Owed owed_ = Owed::Nothing;
  Micros owedAt_{0};
  Micros owedUntil_{0};
  wire::Value value_;
};

}  // namespace tessera::firmware
