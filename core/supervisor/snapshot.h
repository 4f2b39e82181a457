// The supervisor's picture of the fleet at one instant: immutable values that any thread may keep and read.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/ids.h"
#include "base/pose.h"
#include "base/sentence.h"
#include "floor/tag.h"
#include "wire/messages.h"

namespace tessera::locate {
class MagneticMap;
}

namespace tessera::supervisor {

struct LocatingView;

enum class PortState { Closed, Open, Lost };

struct PortView {
  PortState state = PortState::Closed;
  std::string name;
  Sentence sentence;  ///< "The port /dev/ttyUSB0 is open."
};

/// How we stand with a vehicle on the air.
enum class Contact {
  Calling,    ///< never heard, or called again after a restart
  Connected,  ///< a session stands and reports come
  Silent,     ///< a session stood, reports stay away
  Refused,    ///< wrong key or wrong protocol version
};

/// What a vehicle is busy with, as far as orders go.
enum class Task {
  None,
  Running,
  Paused,
  Stopped,
  Finished,
  Jogging,  ///< driven by hand
};

enum class CommandStatus {
  Sent,
  Acknowledged,  ///< the vehicle took it
  Done,          ///< Stop and Clear: taken, and the vehicle stands
  Expired,       ///< a Drive whose time ran out before another one was sent
};

struct CommandView {
  wire::CommandMode mode = wire::CommandMode::Poll;
  MetresPerSecond speed;  ///< negative backwards
  Radians heading;        ///< site frame
  Seconds sentAt;
  Seconds expiry;  ///< after reception
  CommandStatus status = CommandStatus::Sent;
};

struct LinkView {
  std::optional<Seconds> lastHeard;  ///< instant of the last good report; nullopt: none yet
  Seconds age;                       ///< since lastHeard (since the start when nullopt)
  Seconds roundTrip;                 ///< smoothed, vehicle's own waiting taken out
  double loss = 0.0;                 ///< share of recent polls that stayed without answer, 0 to 1
  std::uint32_t reports = 0;
  std::uint32_t missed = 0;
  std::uint32_t forged = 0;
  std::uint32_t replayed = 0;
  std::uint32_t restarts = 0;
  std::uint32_t tagEventsLost = 0;
};

/// A tag that a vehicle's reader saw.
struct ReadView {
  floor::TagUid uid;
  std::uint8_t reader = 0;  ///< index into floor::VehicleSetup::readers
  Seconds at;
  std::optional<Point> place;  ///< of the tag; nullopt: the site does not have it
  bool operator==(const ReadView&) const = default;
};
inline constexpr std::size_t kRecentReads = 16;

struct VehicleView {
  VehicleId id;
  std::string name;
  Contact contact = Contact::Calling;
  Task task = Task::None;
  wire::VehicleState state = wire::VehicleState::Standing;  ///< of the last report
  std::uint16_t faults = 0;                                 ///< wire::Fault bits of the last report
  bool located = false;
  bool doubted = false;                ///< located, but a tag speaks for another place
  Pose pose;                           ///< estimate for the snapshot's time
  std::array<double, 9> covariance{};  ///< of x, y (m) and heading (rad), row by row
  Pose predicted;                      ///< where it will be when a command sent now takes effect
  MetresPerSecond speed;               ///< of the last report
  Radians heading;      ///< of the last report, as the vehicle's own compass and wheels have it, in the site frame
  Radians headingBias;  ///< what the locator has learned of that heading's error: reported minus true
  double batteryVolts = 0.0;
  std::optional<Metres> obstacle;  ///< nearest one that a ranger sees
  LinkView link;
  Sentence firmware;  ///< "1.0.0 on lm3s6965"; empty before identification
  std::string route;  ///< empty: none
  Metres progress;    ///< along the route
  Metres length;      ///< of the route
  Metres crossTrack;  ///< from the way to be driven (drive::drivenWay), positive to its left
  std::optional<CommandView> command;
  Sentence doing;           ///< what the controller decided and why, one sentence; empty without a route
  Sentence waits;           ///< why it stands although it should go: one sentence; empty when it does not wait
  std::uint32_t reads = 0;  ///< tag reads taken by the locator
  std::vector<ReadView> recentReads;  ///< the last of them, kRecentReads at most, oldest first
  std::uint8_t readersAnswering = 0;  ///< bit i: reader i answers, by the last report
  bool finished = false;              ///< the route's end was reached
};

struct ChannelView {
  Seconds cycle;           ///< smoothed time between two commands to the same vehicle
  Seconds slot;            ///< length of an answer slot
  double airFactor = 1.0;  ///< measured airtime over the formula's
  Seconds delay;           ///< measured beside airtime, one way
  std::uint32_t frames = 0;
  std::uint32_t damaged = 0;
  std::uint32_t skippedBytes = 0;
  // Since the last good report of any vehicle; what was heard before it did not keep the two apart.
  std::uint32_t noiseSinceHeard = 0;    ///< bytes that are no frames, and frames with a wrong checksum
  std::uint32_t foreignSinceHeard = 0;  ///< whole frames of vehicles that the site does not have
};

struct Snapshot {
  Seconds time;
  PortView port;
  ChannelView channel;
  std::vector<VehicleView> vehicles;            ///< in the order of the site
  std::shared_ptr<const LocatingView> watched;  ///< of the vehicle that Watch names; null: none, or nothing heard of it

  /// What is known of the floor's iron, a second old at most; the same pointer while it is the same. Never null when it
  /// comes from a supervisor.
  std::shared_ptr<const locate::MagneticMap> magnetic;

  /// Nullptr: no such vehicle.
  [[nodiscard]] const VehicleView* find(VehicleId id) const {
    for (const VehicleView& v : vehicles)
      if (v.id == id) return &v;
    return nullptr;
  }
};

/// Lower case: "calling", "running", "acknowledged", "standing" and so on.
[[nodiscard]] std::string_view nameOf(PortState state);
[[nodiscard]] std::string_view nameOf(Contact contact);
[[nodiscard]] std::string_view nameOf(Task task);
[[nodiscard]] std::string_view nameOf(CommandStatus status);
[[nodiscard]] std::string_view nameOf(wire::VehicleState state);
/// "motor-stall" and so on, one per bit set, in the order of the bits.
[[nodiscard]] std::vector<std::string_view> namesOfFaults(std::uint16_t faults);

}  // namespace tessera::supervisor
