// What the channel tells the supervisor.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "link/session.h"
#include "link/tag_stream.h"

namespace tessera::link {

/// A session stands: commands will be believed from now on.
struct Identified {
  VehicleId vehicle;
  wire::Identity identity;
  bool restarted = false;
};
/// It answers with another key than the site's. Told for each such answer.
struct WrongKey {
  VehicleId vehicle;
};
struct WrongVersion {
  VehicleId vehicle;
  std::uint8_t protocol = 0;
};
/// The vehicle says that it has started anew; it is being called.
struct Restarted {
  VehicleId vehicle;
  wire::ResetCause cause = wire::ResetCause::Other;
};
/// Its answers have stayed away for longer than silentAfter; it is being called. Once until BackAgain or Identified.
struct Silent {
  VehicleId vehicle;
  Seconds since;
};
struct BackAgain {
  VehicleId vehicle;
};
struct Reported {
  VehicleId vehicle;
  wire::Report report;
  Seconds receivedAt;
  Seconds sampledAt;     ///< when the vehicle made the report: receivedAt less the measured way through the air
  Seconds sampledDoubt;  ///< standard deviation of sampledAt
  std::vector<TimedTagEvent> tags;
  unsigned tagEventsLost = 0;
};
/// A command left with a Cycle.
struct CommandSent {
  VehicleId vehicle;
  wire::CycleEntry entry;
  std::uint32_t counter = 0;
  Seconds sentAt;
  Seconds effectiveAt;  ///< when the vehicle is expected to have it
};
/// The vehicle has taken the command that went under this counter.
struct CommandAcknowledged {
  VehicleId vehicle;
  std::uint32_t counter = 0;
};
/// No answer came in time to the command that went under this counter: it or the answer is lost, or late.
struct CommandUnanswered {
  VehicleId vehicle;
  std::uint32_t counter = 0;
};
struct Answered {
  VehicleId vehicle;
  wire::Request request;
  std::optional<wire::Value> value;  ///< nullopt: no answer, for all the repetitions
};
/// The giving of another key has come to this.
struct PairingEnded {
  VehicleId vehicle;
  PairingEnd how = PairingEnd::Unknown;
};
/// A frame of this vehicle was not believed.
struct Disbelieved {
  VehicleId vehicle;
  Disbelief why = Disbelief::Forged;
};
/// Bytes that are no frame, or frames of nobody who belongs to the site.
struct Noise {
  std::uint32_t damaged = 0;  ///< stretches that look like frames, with a wrong checksum
  std::uint32_t skipped = 0;  ///< bytes outside frames
  std::uint32_t foreign = 0;  ///< whole frames from or to strangers
};

using LinkEvent = std::variant<Identified, WrongKey, WrongVersion, Restarted, Silent, BackAgain, Reported, CommandSent,
                               CommandAcknowledged, CommandUnanswered, Answered, PairingEnded, Disbelieved, Noise>;

}  // namespace tessera::link
