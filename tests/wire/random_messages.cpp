#include "wire/random_messages.h"

namespace tessera::wire {
namespace {

TagEvent randomEvent(Random& r) {
  TagEvent e;
  e.reader = static_cast<std::uint8_t>(r() % 16);
  e.kind = static_cast<EventKind>(r() % 4);
  e.age = anyOf<std::uint8_t>(r);
  for (std::size_t i = 0; i < uidLength(e.kind); ++i) e.uid[i] = anyOf<std::uint8_t>(r);
  return e;
}

}  // namespace

Key randomKey(Random& r) {
  Key key;
  for (auto& byte : key) byte = static_cast<std::uint8_t>(r());
  return key;
}

Hello randomHello(Random& r) { return {anyOf<std::uint32_t>(r), anyOf<std::uint32_t>(r)}; }

Identity randomIdentity(Random& r) {
  const auto u8 = [&r] { return anyOf<std::uint8_t>(r); };
  return {anyOf<std::uint32_t>(r),
          anyOf<std::uint32_t>(r),
          anyOf<std::uint16_t>(r),
          u8(),
          u8(),
          u8(),
          u8(),
          u8(),
          u8(),
          u8()};
}

Hail randomHail(Random& r) { return {anyOf<std::uint32_t>(r), anyOf<std::uint8_t>(r)}; }

Report randomReport(Random& r) {
  Report m;
  m.ack = anyOf<std::uint16_t>(r);
  m.state = static_cast<VehicleState>(r() % 7);
  m.faults = anyOf<std::uint16_t>(r);
  m.clock = anyOf<std::uint16_t>(r);
  m.hold = anyOf<std::uint16_t>(r);
  m.speed = anyOf<std::int16_t>(r);
  m.travel = anyOf<std::uint16_t>(r);
  m.bearing = anyOf<std::uint16_t>(r);
  m.battery = anyOf<std::uint8_t>(r);
  m.range = anyOf<std::uint8_t>(r);
  m.readers = anyOf<std::uint8_t>(r);
  m.firstEvent = anyOf<std::uint8_t>(r);
  std::size_t room = Report::kEventRoom;
  for (std::size_t wanted = r() % (Report::kMaxEvents + 1); wanted > 0; --wanted) {
    const TagEvent e = randomEvent(r);
    if (wireSize(e) > room) break;
    room -= wireSize(e);
    m.events[m.eventCount++] = e;
  }
  return m;
}

Request randomRequest(Random& r) {
  const auto type = static_cast<MessageType>(static_cast<unsigned>(MessageType::Get) + r() % 3);
  return {type, anyOf<std::uint8_t>(r), type == MessageType::Set ? anyOf<std::int32_t>(r) : 0};
}

Value randomValue(Random& r) {
  return {anyOf<std::uint16_t>(r), anyOf<std::uint8_t>(r), static_cast<Outcome>(r() % 6), anyOf<std::int32_t>(r)};
}

CycleEntry randomEntry(Random& r) {
  return {static_cast<std::uint8_t>(1 + r() % 254),
          static_cast<CommandMode>(r() % 4),
          anyOf<std::int16_t>(r),
          anyOf<std::uint16_t>(r),
          anyOf<std::uint8_t>(r),
          anyOf<std::uint8_t>(r)};
}

}  // namespace tessera::wire
