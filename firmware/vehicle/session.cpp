#include "firmware/vehicle/session.h"

#include <algorithm>
#include <limits>

#include "firmware/vehicle/version.h"

namespace tessera::firmware {
namespace {

using wire::MessageType;

constexpr Micros kFreePatience = 100ms;     // for answers outside the slots
constexpr Micros kLeastSlotPatience = 5ms;  // for answers in a slot

// Far from the wrap: a hold of more than a minute says no more than a minute does.
std::uint16_t milliseconds(Micros t) {
  return static_cast<std::uint16_t>(std::clamp<std::int64_t>(t.count() / 1000, 0, 65535));
}

}  // namespace

Heard Session::receive(const wire::Frame& frame, Micros now) {
  entropy_.stir(static_cast<std::uint32_t>(now.count()));
  if (frame.header.from != wire::kHostAddress) return {};
  if (pairing_ && frame.header.type != static_cast<std::uint8_t>(MessageType::Pair)) return {};
  switch (static_cast<MessageType>(frame.header.type)) {
    case MessageType::Hello:
      receiveHello(frame, now);
      return {};
    case MessageType::Cycle:
      return receiveCycle(frame, now);
    case MessageType::Get:
    case MessageType::Set:
    case MessageType::Do:
      return receiveRequest(frame, now);
    case MessageType::Pair:
      return receivePair(frame, now);
    default:
      return {};
  }
}

// A Hello only prepares a session: recorded and played back by a stranger, it must not end the running one. The session
// counts from the first frame that carries its MAC, which takes the key. A Hello that the host repeats because our
// Identity got lost gets the same Identity again.
void Session::receiveHello(const wire::Frame& frame, Micros now) {
  if (frame.header.to != person_.address) return;
  const auto sealed = wire::splitMac(frame.payload);
  if (!sealed || frame.header.counter != 0 ||
      !wire::sameMac(wire::macOf(person_.key, 0, frame.header, sealed->body), sealed->mac)) {
    refuse(wire::Refusal::Forged);
    return;
  }
  const auto hello = wire::decodeHello(sealed->body);
  if (!hello) return;
  if (!pending_ || pending_->hostNonce != hello->hostNonce) {
    // A number that came again would make an old session's key again, and its recorded commands good. Who plays two
    // recorded Hellos back in turn gets here in an hour and a half; another start makes sessions new.
    if (hellos_ == std::numeric_limits<std::uint16_t>::max()) return;
    Keyed fresh;
    fresh.hostNonce = hello->hostNonce;
    fresh.hello = ++hellos_;
    fresh.key = wire::deriveSessionKey(person_.key, {hello->hostNonce, boot(), fresh.hello});
    fresh.guard = wire::ReplayGuard{hello->hostCounter};
    pending_ = fresh;
  }
  owe(Owed::Identity, now, kFreePatience);
}

Heard Session::receiveCycle(const wire::Frame& frame, Micros now) {
  const auto part = wire::findEntry(frame.payload, person_.address);
  if (!part || frame.header.to != wire::kEveryone) return {};
  const Micros slot = std::chrono::milliseconds{part->slot * wire::kSlotUnitMs};
  const Micros when = now + part->index * slot;
  const Micros patience = slot.count() == 0 ? kFreePatience : std::max(kLeastSlotPatience, Micros{slot / 2});
  Heard heard;
  if (authentic(frame.header, part->authenticated, part->mac, heard)) {
    ack_ = frame.header.counter;
    ackTime_ = now;
    heard.kind = Heard::Kind::Entry;
    heard.entry = part->entry;
    owe(Owed::Report, when, patience);
  } else if (!current_) {
    owe(Owed::Hail, when, patience);
  }
  return heard;
}

Heard Session::receiveRequest(const wire::Frame& frame, Micros now) {
  const auto sealed = wire::splitMac(frame.payload);
  if (!sealed || frame.header.to != person_.address) return {};
  const auto request = wire::decodeRequest(static_cast<MessageType>(frame.header.type), sealed->body);
  Heard heard;
  if (!request || !authentic(frame.header, sealed->body, sealed->mac, heard)) return {};
  ack_ = frame.header.counter;
  ackTime_ = now;
  heard.kind = Heard::Kind::Request;
  heard.request = *request;
  value_ = {ack_, request->parameter, wire::Outcome::Unknown, 0};
  owe(Owed::Value, now, kFreePatience);
  return heard;
}

bool Session::authentic(const wire::FrameHeader& header, wire::Bytes body, wire::Bytes mac, Heard& heard) {
  wire::Refusal why = wire::Refusal::Forged;
  if (current_) why = current_->guard.accept(current_->key, header, body, mac);
  if (why == wire::Refusal::None) return true;
  if (pending_ && pending_->guard.accept(pending_->key, header, body, mac) == wire::Refusal::None) {
    current_ = pending_;
    pending_.reset();
    former_.reset();
    heard.newSession = true;
    return true;
  }
  // Before any session commands of another time are to be expected: the Hail says all that is to be said.
  if (current_) refuse(why);
  return false;
}

void Session::refuse(wire::Refusal why) {
  ++refused_;
  faults_ |= why == wire::Refusal::Replayed ? wire::kFaultReplayed : wire::kFaultForged;
}

void Session::owe(Owed what, Micros when, Micros patience) {
  owed_ = what;
  owedAt_ = when;
  owedUntil_ = when + patience;
}

Owed Session::due(Micros now) {
  if (owed_ == Owed::Nothing || now < owedAt_) return Owed::Nothing;
  if (now > owedUntil_) owed_ = Owed::Nothing;
  return owed_;
}

void Session::answer(wire::Outcome outcome, std::int32_t value) {
  value_.outcome = outcome;
  value_.value = value;
}

std::uint32_t Session::boot() {
  if (person_.starts == 0) person_.starts = entropy_.number();
  return person_.starts;
}

std::size_t Session::writeIdentity(std::span<std::uint8_t> out) {
  owed_ = Owed::Nothing;
  if (!pending_) return 0;
  wire::Identity identity;
  identity.hostNonce = pending_->hostNonce;
  identity.boot = boot();
  identity.hello = pending_->hello;
  identity.firmwareMajor = kFirmwareMajor;
  identity.firmwareMinor = kFirmwareMinor;
  identity.firmwarePatch = kFirmwarePatch;
  identity.hardware = person_.hardware;
  identity.readers = person_.readers;
  identity.rangers = person_.rangers;
  std::array<std::uint8_t, wire::kMaxPayload> body{};
  return sealLongTerm(MessageType::Identity, wire::Bytes{body}.first(encode(identity, body)), out);
}

std::size_t Session::writeHail(std::span<std::uint8_t> out) {
  owed_ = Owed::Nothing;
  std::array<std::uint8_t, wire::kMaxPayload> body{};
  const wire::Hail hail{boot(), static_cast<std::uint8_t>(person_.cause)};
  return sealLongTerm(MessageType::Hail, wire::Bytes{body}.first(encode(hail, body)), out);
}

std::size_t Session::writeReport(wire::Report report, Micros now, std::span<std::uint8_t> out) {
  owed_ = Owed::Nothing;
  report.ack = ack_;
  report.hold = milliseconds(now - ackTime_);
  faults_ = 0;
  std::array<std::uint8_t, wire::kMaxPayload> body{};
  return seal(MessageType::Report, wire::Bytes{body}.first(encode(report, body)), out);
}

std::size_t Session::writeValue(std::span<std::uint8_t> out) {
  owed_ = Owed::Nothing;
  std::array<std::uint8_t, wire::kMaxPayload> body{};
  return seal(MessageType::Value, wire::Bytes{body}.first(encode(value_, body)), out);
}

std::size_t Session::seal(MessageType type, wire::Bytes body, std::span<std::uint8_t> out) {
  if (!current_) return 0;
  const wire::FrameHeader header{wire::kHostAddress, person_.address, static_cast<std::uint8_t>(type), 0};
  return wire::sealFrame(current_->key, ++current_->sent, header, body, out);
}

std::size_t Session::sealLongTerm(MessageType type, wire::Bytes body, std::span<std::uint8_t> out) const {
  const wire::FrameHeader header{wire::kHostAddress, person_.address, static_cast<std::uint8_t>(type), 0};
  return wire::sealFrame(person_.key, 0, header, body, out);
}

}  // namespace tessera::firmware
