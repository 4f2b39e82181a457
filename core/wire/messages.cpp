#include "wire/messages.h"

#include <algorithm>

namespace tessera::wire {
namespace {

std::size_t sizeOf(const ByteWriter& w) { return w.overrun() ? 0 : w.size(); }

// A body is good when it was read to its end and no further.
bool exact(const ByteReader& r) { return !r.overrun() && r.remaining() == 0; }

void put(ByteWriter& w, const CycleEntry& e) {
  w.u8(e.vehicle);
  w.u8(static_cast<std::uint8_t>(e.mode));
  w.i16(e.speed);
  w.u16(e.bearing);
  w.u8(e.expiry);
  w.u8(e.nextEvent);
}

bool takeEvent(ByteReader& r, TagEvent& e) {
  const std::uint8_t head = r.u8();
  if ((head >> 4) > static_cast<std::uint8_t>(EventKind::Uid10)) return false;
  e.kind = static_cast<EventKind>(head >> 4);
  e.reader = head & 0x0F;
  e.age = r.u8();
  const Bytes uid = r.bytes(uidLength(e.kind));
  std::copy(uid.begin(), uid.end(), e.uid.begin());
  return !r.overrun();
}

}  // namespace

std::size_t encode(const Hello& m, std::span<std::uint8_t> out) {
  ByteWriter w{out};
  w.u32(m.hostNonce);
  w.u32(m.hostCounter);
  return sizeOf(w);
}

std::size_t encode(const Identity& m, std::span<std::uint8_t> out) {
  ByteWriter w{out};
  w.u32(m.hostNonce);
  w.u32(m.boot);
  w.u16(m.hello);
  for (std::uint8_t v :
       {m.protocol, m.firmwareMajor, m.firmwareMinor, m.firmwarePatch, m.hardware, m.readers, m.rangers})
    w.u8(v);
  return sizeOf(w);
}

std::size_t encode(const Hail& m, std::span<std::uint8_t> out) {
  ByteWriter w{out};
  w.u32(m.boot);
  w.u8(m.cause);
  return sizeOf(w);
}

std::size_t encode(const Report& m, std::span<std::uint8_t> out) {
  ByteWriter w{out};
  w.u16(m.ack);
  w.u8(static_cast<std::uint8_t>(m.state));
  w.u16(m.faults);
  w.u16(m.clock);
  w.u16(m.hold);
  w.i16(m.speed);
  w.u16(m.travel);
  w.u16(m.bearing);
  w.u8(m.battery);
  w.u8(m.range);
  w.u8(m.readers);
  w.u8(m.firstEvent);
  if (m.eventCount > m.events.size()) return 0;
  for (std::size_t i = 0; i < m.eventCount; ++i) {
    const TagEvent& e = m.events[i];
    w.u8(static_cast<std::uint8_t>((static_cast<unsigned>(e.kind) << 4) | (e.reader & 0x0FU)));
    w.u8(e.age);
    w.bytes(Bytes{e.uid}.first(uidLength(e.kind)));
  }
  return w.size() > Report::kFixedSize + Report::kEventRoom ? 0 : sizeOf(w);
}

std::size_t encode(const Request& m, std::span<std::uint8_t> out) {
  ByteWriter w{out};
  w.u8(m.parameter);
  if (m.type == MessageType::Set) w.i32(m.value);
  return sizeOf(w);
}

std::size_t encode(const Value& m, std::span<std::uint8_t> out) {
  ByteWriter w{out};
  w.u16(m.ack);
  w.u8(m.parameter);
  w.u8(static_cast<std::uint8_t>(m.outcome));
  w.i32(m.value);
  return sizeOf(w);
}

std::optional<Hello> decodeHello(Bytes body) {
  ByteReader r{body};
  Hello m;
  m.hostNonce = r.u32();
  m.hostCounter = r.u32();
  return exact(r) ? std::optional{m} : std::nullopt;
}

std::optional<Identity> decodeIdentity(Bytes body) {
  ByteReader r{body};
  Identity m;
  m.hostNonce = r.u32();
  m.boot = r.u32();
  m.hello = r.u16();
  for (std::uint8_t* v :
       {&m.protocol, &m.firmwareMajor, &m.firmwareMinor, &m.firmwarePatch, &m.hardware, &m.readers, &m.rangers})
    *v = r.u8();
  return exact(r) ? std::optional{m} : std::nullopt;
}

std::optional<Hail> decodeHail(Bytes body) {
  ByteReader r{body};
  Hail m;
  m.boot = r.u32();
  m.cause = r.u8();
  return exact(r) ? std::optional{m} : std::nullopt;
}

std::optional<Report> decodeReport(Bytes body) {
  ByteReader r{body};
  Report m;
  m.ack = r.u16();
  const std::uint8_t state = r.u8();
  if (state > static_cast<std::uint8_t>(VehicleState::Faulted)) return std::nullopt;
  m.state = static_cast<VehicleState>(state);
  m.faults = r.u16();
  m.clock = r.u16();
  m.hold = r.u16();
  m.speed = r.i16();
  m.travel = r.u16();
  m.bearing = r.u16();
  m.battery = r.u8();
  m.range = r.u8();
  m.readers = r.u8();
  m.firstEvent = r.u8();
  if (r.overrun() || r.remaining() > Report::kEventRoom) return std::nullopt;
  while (r.remaining() > 0) {
    if (m.eventCount == m.events.size() || !takeEvent(r, m.events[m.eventCount])) return std::nullopt;
    ++m.eventCount;
  }
  return m;
}

std::optional<Request> decodeRequest(MessageType type, Bytes body) {
  if (type != MessageType::Get && type != MessageType::Set && type != MessageType::Do) return std::nullopt;
  ByteReader r{body};
  Request m;
  m.type = type;
  m.parameter = r.u8();
  if (type == MessageType::Set) m.value = r.i32();
  return exact(r) ? std::optional{m} : std::nullopt;
}

std::optional<Value> decodeValue(Bytes body) {
  ByteReader r{body};
  Value m;
  m.ack = r.u16();
  m.parameter = r.u8();
  const std::uint8_t outcome = r.u8();
  m.value = r.i32();
  if (!exact(r) || outcome > static_cast<std::uint8_t>(Outcome::Failed)) return std::nullopt;
  m.outcome = static_cast<Outcome>(outcome);
  return m;
}

CycleWriter::CycleWriter(std::uint8_t slot, std::uint32_t counter) : counter_{counter} { payload_[0] = slot; }

bool CycleWriter::add(const CycleEntry& entry, const Key& sessionKey) {
  if (count_ == kMaxCycleEntries) return false;
  std::array<std::uint8_t, 10> authenticated{};
  ByteWriter body{authenticated};
  body.u8(payload_[0]);
  body.u8(static_cast<std::uint8_t>(count_));
  put(body, entry);
  const FrameHeader header{kEveryone, kHostAddress, static_cast<std::uint8_t>(MessageType::Cycle), 0};
  ByteWriter w{std::span{payload_}.subspan(1 + count_ * kCycleEntrySize)};
  put(w, entry);
  w.bytes(macOf(sessionKey, counter_, header, authenticated));
  ++count_;
  return true;
}

std::size_t CycleWriter::finish(std::span<std::uint8_t> out) const {
  const FrameHeader header{kEveryone, kHostAddress, static_cast<std::uint8_t>(MessageType::Cycle),
                           static_cast<std::uint16_t>(counter_)};
  return encodeFrame(header, Bytes{payload_}.first(1 + count_ * kCycleEntrySize), out);
}

std::optional<CyclePart> findEntry(Bytes cyclePayload, std::uint8_t vehicle) {
  if (cyclePayload.empty() || (cyclePayload.size() - 1) % kCycleEntrySize != 0) return std::nullopt;
  ByteReader r{cyclePayload};
  const std::uint8_t slot = r.u8();
  for (std::uint8_t index = 0; r.remaining() > 0; ++index) {
    const Bytes raw = r.bytes(kCycleEntrySize);
    if (raw[0] != vehicle) continue;
    if (raw[1] > static_cast<std::uint8_t>(CommandMode::Clear)) return std::nullopt;
    CyclePart part;
    part.index = index;
    part.slot = slot;
    ByteReader e{raw};
    part.entry.vehicle = e.u8();
    part.entry.mode = static_cast<CommandMode>(e.u8());
    part.entry.speed = e.i16();
    part.entry.bearing = e.u16();
    part.entry.expiry = e.u8();
    part.entry.nextEvent = e.u8();
    part.authenticated[0] = slot;
    part.authenticated[1] = index;
    std::copy_n(raw.begin(), 8, part.authenticated.begin() + 2);
    std::copy_n(raw.begin() + 8, part.mac.size(), part.mac.begin());
    return part;
  }
  return std::nullopt;
}

}  // namespace tessera::wire
