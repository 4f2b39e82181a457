// What host and vehicle say to each other. Numbers are little-endian; every struct states unit and range as on the
// wire. docs/protocol.md gives every byte with worked examples.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "wire/frame.h"
#include "wire/security.h"

namespace tessera::wire {

inline constexpr std::uint8_t kProtocolVersion = 1;

enum class MessageType : std::uint8_t {
  Hello = 0x01,     ///< host: who are you? opens a session. Long-term key, counter 0
  Cycle = 0x02,     ///< host, to everyone: commands for up to four vehicles, each of which answers in its slot
  Get = 0x03,       ///< host: read a parameter
  Set = 0x04,       ///< host: write a parameter (kept in EEPROM)
  Do = 0x05,        ///< host: start an action
  Pair = 0x06,      ///< host: take this long-term key (wire/pairing.h)
  Identity = 0x81,  ///< vehicle: answer to Hello. Long-term key, counter 0
  Report = 0x82,    ///< vehicle: answer to its entry of a Cycle
  Value = 0x83,     ///< vehicle: answer to Get, Set, Do
  Hail = 0x84,      ///< vehicle: "I have no session with you", in its slot. Long-term key, counter 0
  Paired = 0x85,    ///< vehicle: answer to Pair. Long-term key in force by then, counter 0
};

/// Body of Hello (long-term key). 8 bytes.
struct Hello {
  std::uint32_t hostNonce = 0;
  std::uint32_t hostCounter = 0;  ///< last counter that the host used on this channel; the session's go on above it
  bool operator==(const Hello&) const = default;
};

/// Body of Identity (long-term key). 17 bytes.
struct Identity {
  std::uint32_t hostNonce = 0;  ///< the Hello's, so that an old Identity is worth nothing
  std::uint32_t boot = 0;
  std::uint16_t hello = 0;
  std::uint8_t protocol = kProtocolVersion;
  std::uint8_t firmwareMajor = 0;
  std::uint8_t firmwareMinor = 0;
  std::uint8_t firmwarePatch = 0;
  std::uint8_t hardware = 0;  ///< 1 LM3S6965, 2 host build, 255 other
  std::uint8_t readers = 0;   ///< reader heads, 1 to 8
  std::uint8_t rangers = 0;
  bool operator==(const Identity&) const = default;
};

/// Body of Hail (long-term key). 5 bytes.
struct Hail {
  std::uint32_t boot = 0;
  std::uint8_t cause = 0;  ///< of the last start: ResetCause
  bool operator==(const Hail&) const = default;
};

enum class ResetCause : std::uint8_t { PowerOn = 0, Watchdog = 1, Software = 2, Other = 3 };

enum class CommandMode : std::uint8_t {
  Poll = 0,   ///< only report; a running command neither ends nor is prolonged
  Drive = 1,  ///< Ctrl(V, Dir): hold speed and bearing until the next command or until it expires
  Stop = 2,   ///< brake to a stand and stay there
  Clear = 3,  ///< stand, and forget latched faults whose cause is gone
};

/// One vehicle's part of a Cycle: 8 bytes and the MAC of (slot, index, these 8 bytes) under its session key.
struct CycleEntry {
  std::uint8_t vehicle = 0;
  CommandMode mode = CommandMode::Poll;
  std::int16_t speed = 0;      ///< mm/s, negative backwards
  std::uint16_t bearing = 0;   ///< 1/65536 turn, clockwise from north, of the vehicle's nose
  std::uint8_t expiry = 0;     ///< 20 ms: the vehicle stops by itself this long after reception, 0 = at once
  std::uint8_t nextEvent = 0;  ///< number of the first tag event that the host has not got
  bool operator==(const CycleEntry&) const = default;
};

inline constexpr std::size_t kCycleEntrySize = 12;
inline constexpr std::size_t kMaxCycleEntries = (kMaxPayload - 1) / kCycleEntrySize;
inline constexpr std::uint8_t kSlotUnitMs = 4;
inline constexpr std::uint8_t kExpiryUnitMs = 20;
inline constexpr std::uint8_t kAgeUnitMs = 10;

enum class VehicleState : std::uint8_t {
  Standing = 0,  ///< stopped by command, or never commanded
  Driving = 1,
  Turning = 2,   ///< on the spot
  Obstacle = 3,  ///< stopped before an obstacle, or by kFaultRanger; goes on when it is gone and commands still come
  Expired = 4,   ///< stopped because commands stopped coming
  Calibrating = 5,
  Faulted = 6,  ///< stopped by a latched fault, until Clear
};

/// Bits of Report::faults. The latched ones stop the vehicle until Clear.
enum Fault : std::uint16_t {
  kFaultMotorStall = 1U << 0,    ///< latched: a wheel does not turn although driven
  kFaultEncoder = 1U << 1,       ///< latched: a wheel turns without being driven, or against its drive
  kFaultCompass = 1U << 2,       ///< no answer from the compass; heading is kept from the wheels
  kFaultCompassRange = 1U << 3,  ///< field too strong, too weak or overflowing; heading is kept from the wheels
  kFaultReader = 1U << 4,        ///< a reader does not answer
  kFaultBattery = 1U << 5,       ///< battery low
  kFaultEeprom = 1U << 6,        ///< settings unreadable (stands, whatever Clear says), or could not be written
  kFaultWatchdog = 1U << 7,      ///< latched: last start was the watchdog's
  kFaultRadio = 1U << 8,         ///< the radio module did not take its parameters
  kFaultForged = 1U << 9,        ///< since the last report a command was refused: wrong MAC
  kFaultReplayed = 1U << 10,     ///< since the last report a command was refused: seen before
  kFaultEventsLost = 1U << 11,   ///< tag events were dropped because the host did not fetch them
  kFaultRanger = 1U << 12,       ///< a ranger does not answer, which counts as an obstacle
};

enum class EventKind : std::uint8_t { Left = 0, Uid4 = 1, Uid7 = 2, Uid10 = 3 };

/// A tag came under a reader, or left it. Wire: (kind << 4 | reader) u8, age u8, UID bytes (none for Left).
struct TagEvent {
  std::uint8_t reader = 0;  ///< 0 to 15, from the vehicle's left to its right
  EventKind kind = EventKind::Left;
  std::uint8_t age = 0;  ///< 10 ms before the report was made; 255 = older. Left: age of the last good read
  std::array<std::uint8_t, 10> uid{};
  bool operator==(const TagEvent&) const = default;
};
[[nodiscard]] constexpr std::size_t uidLength(EventKind k) {
  return k == EventKind::Left ? 0 : 1 + 3 * static_cast<std::size_t>(k);
}
[[nodiscard]] constexpr std::size_t wireSize(const TagEvent& e) { return 2 + uidLength(e.kind); }

inline constexpr std::uint8_t kFarthestRange = 254;  ///< cm

/// Body of Report (session key): 19 bytes and the tag events that fit.
struct Report {
  static constexpr std::size_t kFixedSize = 19;
  static constexpr std::size_t kEventRoom = kMaxPayload - kFixedSize - 4;
  static constexpr std::size_t kMaxEvents = kEventRoom / 2;

  std::uint16_t ack = 0;  ///< low 16 bits of the counter of the last frame accepted from the host
  VehicleState state = VehicleState::Standing;
  std::uint16_t faults = 0;
  std::uint16_t clock = 0;      ///< ms, the vehicle's own, when the report was made
  std::uint16_t hold = 0;       ///< ms from the last byte of the acknowledged frame to the making of the report
  std::int16_t speed = 0;       ///< mm/s, from the wheel encoders
  std::uint16_t travel = 0;     ///< mm travelled, forwards minus backwards, modulo 65536
  std::uint16_t bearing = 0;    ///< 1/65536 turn, clockwise from north
  std::uint8_t battery = 0;     ///< 0.1 V
  std::uint8_t range = 255;     ///< cm to the nearest obstacle; kFarthestRange = so far or farther, 255 = none seen
  std::uint8_t readers = 0;     ///< bit i: reader i answers
  std::uint8_t firstEvent = 0;  ///< number of events[0]; the others follow it, modulo 256
  std::uint8_t eventCount = 0;
  std::array<TagEvent, kMaxEvents> events{};
  bool operator==(const Report&) const = default;
};

/// Body of Get: parameter u8. Body of Set: parameter u8, value i32. Body of Do: action u8.
struct Request {
  MessageType type = MessageType::Get;
  std::uint8_t parameter = 0;  ///< wire::Parameter, or wire::Action for Do
  std::int32_t value = 0;
  bool operator==(const Request&) const = default;
};

enum class Outcome : std::uint8_t { Done = 0, Started = 1, Unknown = 2, OutOfRange = 3, Busy = 4, Failed = 5 };

/// Body of Value (session key). 8 bytes.
struct Value {
  std::uint16_t ack = 0;
  std::uint8_t parameter = 0;
  Outcome outcome = Outcome::Done;
  std::int32_t value = 0;
  bool operator==(const Value&) const = default;
};

// Bodies without their MAC. decode: nullopt for a wrong length or a value that no vehicle or host sends.
std::size_t encode(const Hello& m, std::span<std::uint8_t> out);
std::size_t encode(const Identity& m, std::span<std::uint8_t> out);
std::size_t encode(const Hail& m, std::span<std::uint8_t> out);
std::size_t encode(const Report& m, std::span<std::uint8_t> out);  ///< 0 when the events do not fit
std::size_t encode(const Request& m, std::span<std::uint8_t> out);
std::size_t encode(const Value& m, std::span<std::uint8_t> out);
[[nodiscard]] std::optional<Hello> decodeHello(Bytes body);
[[nodiscard]] std::optional<Identity> decodeIdentity(Bytes body);
[[nodiscard]] std::optional<Hail> decodeHail(Bytes body);
[[nodiscard]] std::optional<Report> decodeReport(Bytes body);
[[nodiscard]] std::optional<Request> decodeRequest(MessageType type, Bytes body);
[[nodiscard]] std::optional<Value> decodeValue(Bytes body);

/// Builds the payload of a Cycle. Entries are authenticated one by one, each for its own vehicle.
class CycleWriter {
public:
  /// slot: length of one answer slot in units of 4 ms; vehicle i answers i slots after the frame's end.
  CycleWriter(std::uint8_t slot, std::uint32_t counter);
  /// False when four entries stand in it already.
  bool add(const CycleEntry& entry, const Key& sessionKey);
  [[nodiscard]] std::size_t count() const { return count_; }
  /// The whole frame; returns its size.
  std::size_t finish(std::span<std::uint8_t> out) const;

private:
  std::uint32_t counter_;
  std::array<std::uint8_t, kMaxPayload> payload_{};
  std::size_t count_ = 0;
};

/// One vehicle's view of a received Cycle.
struct CyclePart {
  CycleEntry entry;
  std::uint8_t index = 0;                        ///< answer after index * slot
  std::uint8_t slot = 0;                         ///< 4 ms
  std::array<std::uint8_t, 10> authenticated{};  ///< slot, index, the entry's 8 bytes: the MAC's body
  Mac mac{};
};
/// The entry for `vehicle`, nullopt when there is none or the payload is malformed. Check the MAC before believing it.
[[nodiscard]] std::optional<CyclePart> findEntry(Bytes cyclePayload, std::uint8_t vehicle);

}  // namespace tessera::wire
