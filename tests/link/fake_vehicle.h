// A vehicle of a few lines, built from the wire alone: enough to meet a host, to be commanded and to report. Scripted
// by its public members; knows no physics.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "base/ids.h"
#include "base/units.h"
#include "wire/messages.h"
#include "wire/pairing.h"
#include "wire/security.h"

namespace tessera::test {

class FakeVehicle {
public:
  struct Answer {
    std::vector<std::uint8_t> bytes;
    Seconds delay;  ///< after the received frame's last byte
  };

  FakeVehicle(std::uint8_t id, const wire::Key& longTerm) : address{id}, key{longTerm} {}

  /// Switched off and on again: session and event numbers are gone, the start counter has grown.
  void restart() {
    if (countsStarts) ++boot;
    hellos_ = 0;
    session_.reset();
    events_.clear();
    firstEvent_ = 0;
    report.travel = 0;
  }
  void read(std::uint8_t reader, std::array<std::uint8_t, 4> uid, Seconds at) {
    wire::TagEvent e;
    e.reader = reader;
    e.kind = wire::EventKind::Uid4;
    std::copy(uid.begin(), uid.end(), e.uid.begin());
    events_.push_back({e, at});
  }
  void note(const wire::TagEvent& event, Seconds at) { events_.push_back({event, at}); }
  void left(std::uint8_t reader, Seconds at) {
    events_.push_back({wire::TagEvent{reader, wire::EventKind::Left, 0, {}}, at});
  }

  /// What it answers to a frame whose last byte came at `now`.
  std::optional<Answer> hear(const wire::Frame& frame, Seconds now) {
    if (!on) return std::nullopt;
    const auto type = static_cast<wire::MessageType>(frame.header.type);
    if (frame.header.to != address && frame.header.to != wire::kEveryone) return std::nullopt;
    if (type == wire::MessageType::Cycle) return hearCycle(frame, now);
    const auto sealed = wire::splitMac(frame.payload);
    if (!sealed) return std::nullopt;
    if (type == wire::MessageType::Hello) return hearHello(frame, *sealed);
    if (type == wire::MessageType::Pair && hearsNoPair) return std::nullopt;
    if (type == wire::MessageType::Pair) return hearPair(frame, *sealed);
    return hearRequest(frame, *sealed);
  }

  // The script.
  std::uint8_t address;
  wire::Key key;
  bool on = true;
  bool countsStarts = true;  ///< false: its EEPROM is dead
  bool checksHello = true;   ///< false: answers every Hello, with its own key
  std::uint8_t protocol = wire::kProtocolVersion;
  std::uint32_t boot = 1;
  Seconds sluggishness{0.001};  ///< before it answers; counted into the hold
  wire::Report report;          ///< what it tells, but for ack, clock, hold and events
  std::function<void(const wire::CycleEntry&, Seconds)> onCommand;
  std::function<void(Seconds)> beforeReport;        ///< may bring `report` up to this instant
  wire::Outcome pairOutcome = wire::Outcome::Done;  ///< what it says to a Pair; takes the key with Done
  bool hearsNoPair = false;
  bool takesPairsInSilence = false;  ///< the answer is lost
  // What it saw.
  unsigned pairs = 0;
  std::vector<wire::CycleEntry> commands;
  std::uint32_t forged = 0;
  std::uint32_t replayed = 0;
  std::size_t eventsWaiting() const { return events_.size(); }

private:
  struct Event {
    wire::TagEvent event;
    Seconds at;
  };
  struct Session {
    wire::Key key;
    wire::ReplayGuard guard;
    std::uint32_t counter = 0;
    wire::SessionNonce nonce{};
  };
  using Buffer = std::array<std::uint8_t, wire::kMaxFrame>;

  Answer seal(wire::MessageType type, wire::Bytes body, bool longTerm, Seconds delay) {
    Buffer out{};
    const wire::FrameHeader header{wire::kHostAddress, address, static_cast<std::uint8_t>(type), 0};
    const std::size_t size =
        wire::sealFrame(longTerm ? key : session_->key, longTerm ? 0 : ++session_->counter, header, body, out);
    return {{out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size)}, delay};
  }

  std::optional<Answer> hearHello(const wire::Frame& frame, const wire::Sealed& sealed) {
    const auto hello = wire::decodeHello(sealed.body);
    if (!hello) return std::nullopt;
    if (checksHello && !wire::sameMac(wire::macOf(key, 0, frame.header, sealed.body), sealed.mac)) {
      ++forged;
      return std::nullopt;
    }
    wire::Identity who;
    who.hostNonce = hello->hostNonce;
    who.boot = boot;
    who.hello = ++hellos_;
    who.protocol = protocol;
    who.hardware = 255;
    who.readers = 3;
    session_ = Session{wire::deriveSessionKey(key, {hello->hostNonce, boot, hellos_}),
                       wire::ReplayGuard{hello->hostCounter},
                       0,
                       {hello->hostNonce, boot, hellos_}};
    former_.reset();
    Buffer body{};
    const std::size_t size = wire::encode(who, body);
    return seal(wire::MessageType::Identity, wire::Bytes{body}.first(size), true, sluggishness);
  }

  std::optional<Answer> hearCycle(const wire::Frame& frame, Seconds now) {
    const auto part = wire::findEntry(frame.payload, address);
    if (!part) return std::nullopt;
    const Seconds delay = Seconds{part->index * part->slot * wire::kSlotUnitMs / 1000.0} + sluggishness;
    if (!session_) {
      Buffer body{};
      const std::size_t size = wire::encode(wire::Hail{boot, 0}, body);
      return seal(wire::MessageType::Hail, wire::Bytes{body}.first(size), true, delay);
    }
    const wire::Refusal refusal = session_->guard.accept(session_->key, frame.header, part->authenticated, part->mac);
    if (refusal != wire::Refusal::None) {
      ++(refusal == wire::Refusal::Replayed ? replayed : forged);
      return std::nullopt;
    }
    commands.push_back(part->entry);
    if (onCommand) onCommand(part->entry, now);
    while (!events_.empty() && static_cast<std::int8_t>(part->entry.nextEvent - firstEvent_) > 0) {
      events_.pop_front();
      ++firstEvent_;
    }
    return makeReport(now, delay);
  }

  Answer makeReport(Seconds now, Seconds delay) {
    const Seconds made = now + delay;
    if (beforeReport) beforeReport(made);
    wire::Report r = report;
    r.ack = static_cast<std::uint16_t>(session_->guard.last());
    r.hold = static_cast<std::uint16_t>(std::lround(delay.value() * 1000));
    r.clock = static_cast<std::uint16_t>(std::llround(made.value() * 1000));
    r.firstEvent = firstEvent_;
    std::size_t room = wire::Report::kEventRoom;
    for (const Event& e : events_) {
      if (wire::wireSize(e.event) > room) break;
      room -= wire::wireSize(e.event);
      wire::TagEvent told = e.event;
      told.age = static_cast<std::uint8_t>(std::clamp((made - e.at).value() * 100, 0.0, 255.0));
      r.events[r.eventCount++] = told;
    }
    Buffer body{};
    const std::size_t size = wire::encode(r, body);
    return seal(wire::MessageType::Report, wire::Bytes{body}.first(size), false, delay);
  }

  std::optional<Answer> hearRequest(const wire::Frame& frame, const wire::Sealed& sealed) {
    if (!session_) return std::nullopt;
    if (session_->guard.accept(session_->key, frame.header, sealed.body, sealed.mac) != wire::Refusal::None)
      return std::nullopt;
    const auto request = wire::decodeRequest(static_cast<wire::MessageType>(frame.header.type), sealed.body);
    if (!request) return std::nullopt;
    Buffer body{};
    const std::size_t size = wire::encode(wire::Value{static_cast<std::uint16_t>(session_->guard.last()),
                                                      request->parameter, wire::Outcome::Done, request->value},
                                          body);
    return seal(wire::MessageType::Value, wire::Bytes{body}.first(size), false, sluggishness);
  }

  // Like the firmware: the former session is good for the same Pair once more.
  std::optional<Answer> hearPair(const wire::Frame& frame, const wire::Sealed& sealed) {
    const auto pair = wire::decodePair(sealed.body);
    std::optional<Session>& session = session_ ? session_ : former_;
    if (!pair || !session ||
        session->guard.accept(session->key, frame.header, sealed.body, sealed.mac) != wire::Refusal::None)
      return std::nullopt;
    const std::uint32_t counter = session->guard.last();
    const std::uint32_t hostNonce = session->nonce.host;
    const auto fresh = wire::openPair(*pair, session_ ? key : formerKey_, {session->nonce, counter});
    if (!fresh) return std::nullopt;
    ++pairs;
    if (pairOutcome == wire::Outcome::Done && session_) {
      formerKey_ = key;
      key = *fresh;
      former_ = session_;
      session_.reset();
    }
    if (takesPairsInSilence) return std::nullopt;
    Buffer body{};
    const std::size_t size = wire::encode(wire::Paired{hostNonce, counter, pairOutcome}, body);
    return seal(wire::MessageType::Paired, wire::Bytes{body}.first(size), true, Seconds{0.03});
  }

  std::uint16_t hellos_ = 0;
  std::optional<Session> former_;
  wire::Key formerKey_{};
  std::optional<Session> session_;
  std::deque<Event> events_;
  std::uint8_t firstEvent_ = 0;
};

}  // namespace tessera::test
