// What happened, in a sentence for people and a kind for programs. One event opens an episode, one closes it; what
// lasts is not repeated in between.
#pragma once

#include <optional>
#include <string_view>

#include "base/ids.h"
#include "base/sentence.h"
#include "base/units.h"
#include "link/session.h"
#include "wire/messages.h"

namespace tessera::supervisor {

enum class Severity { Info, Warning, Error };

enum class EventKind {
  PortOpened,
  PortLost,
  Identified,      ///< a vehicle answered and a session stands
  WrongKey,        ///< a vehicle answers but was not set up with the site's key
  WrongVersion,    ///< a vehicle speaks another version of the protocol
  Silent,          ///< a vehicle's answers stay away
  Restarted,       ///< a vehicle lost its session because it started anew
  Located,         ///< its place became known for the first time
  Lost,            ///< its place is no longer known; over: it is again
  Doubted,         ///< a tag speaks for another place; over: others have decided
  Fault,           ///< one of wire::Fault, named in the sentence
  Obstacle,        ///< stands before an obstacle
  Expired,         ///< stopped by itself because commands stopped coming
  DamagedFrames,   ///< bytes on the air that are no frames: noise, collision or a changed byte
  ForgedFrames,    ///< frames that claim to be from a vehicle but do not bear its key
  ReplayedFrames,  ///< genuine frames seen before
  StrangeFrames,   ///< frames of a vehicle that this site does not have, or that make no sense
  TagEventsLost,   ///< reports went missing together with tag reads
  UnknownTag,      ///< a UID that no tile of the site has
  RouteStarted,
  RouteFinished,
  StoppedAll,    ///< StopAll was ordered
  RouteStopped,  ///< given up by Stop or StopAll
  DrivenByHand,
  Paused,
  Resumed,
  OrderRefused,  ///< the sentence says why
  Answer,        ///< to Ask
  Paired,        ///< to Pair: `pairing` tells which key the vehicle has. Unknown is followed by another one
};

/// What a vehicle said to an Ask, for programs.
struct AskAnswer {
  wire::Request request;
  std::optional<wire::Value> value;  ///< nullopt: it did not answer
  bool operator==(const AskAnswer&) const = default;
};

struct Event {
  Seconds time;
  Severity severity = Severity::Info;
  std::optional<VehicleId> vehicle;
  EventKind kind = EventKind::PortOpened;
  bool over = false;                          ///< closes the episode that an event of the same kind and vehicle opened
  Sentence sentence;                          ///< complete
  std::optional<AskAnswer> answer{};          ///< of kind Answer
  std::optional<link::PairingEnd> pairing{};  ///< of kind Paired
  bool operator==(const Event&) const = default;
};

/// "info", "warning", "error".
[[nodiscard]] std::string_view nameOf(Severity severity);
/// The enumerator in lower case with hyphens, e.g. "port-lost".
[[nodiscard]] std::string_view nameOf(EventKind kind);

}  // namespace tessera::supervisor
