// The vehicle's side of the conversation with its host: who may command it, what it owes an answer to, and when.
// Frames go in, frames come out; the radio is not known here.
#pragma once

#include <cstdint>
#include <optional>

#include "firmware/vehicle/entropy.h"
#include "firmware/vehicle/time.h"
#include "wire/messages.h"

namespace tessera::firmware {

/// What a received frame asks of the vehicle. Only genuine, fresh requests get this far.
struct Heard {
  enum class Kind : std::uint8_t { Nothing, Entry, Request };
  Kind kind = Kind::Nothing;
  bool newSession = false;  ///< the first frame of a session
  wire::CycleEntry entry;
  wire::Request request;
};

/// An answer that is due now.
enum class Owed : std::uint8_t { Nothing, Identity, Hail, Report, Value };

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
  /// The answer to the request that was heard last.
  void answer(wire::Outcome outcome, std::int32_t value);

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
