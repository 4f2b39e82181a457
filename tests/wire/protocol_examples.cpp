#include "wire/protocol_examples.h"

#include <string_view>

#include "wire/messages.h"
#include "wire/pairing.h"
#include "wire/parameters.h"

namespace tessera::wire {
namespace {

constexpr Key kLongTerm7{0x00, 0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x07,
                         0x08, 0x09, 0x0A, 0x0B, 0x0C, 0x0D, 0x0E, 0x0F};
constexpr Key kLongTerm9{0x10, 0x11, 0x12, 0x13, 0x14, 0x15, 0x16, 0x17,
                         0x18, 0x19, 0x1A, 0x1B, 0x1C, 0x1D, 0x1E, 0x1F};
constexpr Key kNew7{0xC0, 0xC1, 0xC2, 0xC3, 0xC4, 0xC5, 0xC6, 0xC7, 0xC8, 0xC9, 0xCA, 0xCB, 0xCC, 0xCD, 0xCE, 0xCF};
constexpr std::uint32_t kHostNonce = 0x1A2B3C4D;
constexpr std::uint32_t kHostCounter = 1000;
constexpr std::uint32_t kPairCounter = 2000;  // later in the same session
constexpr std::uint32_t kBoot = 42;
constexpr std::uint16_t kBearing = 7282;  // 40 degrees

template <class Message>
std::vector<std::uint8_t> sealed(const Key& key, std::uint32_t counter, bool fromHost, MessageType type,
                                 const Message& m) {
  std::array<std::uint8_t, kMaxPayload> body{};
  const std::size_t n = encode(m, body);
  const std::uint8_t to = fromHost ? 7 : 0;
  const FrameHeader header{to, static_cast<std::uint8_t>(7 - to), static_cast<std::uint8_t>(type), 0};
  std::vector<std::uint8_t> out(kMaxFrame);
  out.resize(sealFrame(key, counter, header, Bytes{body}.first(n), out));
  return out;
}

std::vector<std::uint8_t> finished(const CycleWriter& cycle) {
  std::vector<std::uint8_t> out(kMaxFrame);
  out.resize(cycle.finish(out));
  return out;
}

Report reportDriving() {
  Report r;
  r.ack = kHostCounter + 1;
  r.state = VehicleState::Driving;
  r.clock = 12345;
  r.hold = 3;
  r.speed = 118;
  r.travel = 5;
  r.bearing = kBearing;
  r.battery = 124;
  r.readers = 0b111;
  r.eventCount = 1;
  r.events[0] = {1, EventKind::Uid7, 3, {0x04, 0xB1, 0x5F, 0x82, 0x3A, 0x2F, 0x48}};
  return r;
}

Report reportLater() {
  Report r = reportDriving();
  r.ack = kHostCounter + 2;
  r.faults = kFaultReplayed;
  r.clock = 12545;
  r.hold = 43;
  r.travel = 29;
  r.firstEvent = 1;
  r.eventCount = 2;
  r.events[0] = {1, EventKind::Left, 12, {}};
  r.events[1] = {0, EventKind::Uid4, 0, {0xDE, 0xAD, 0xBE, 0xEF}};
  return r;
}

}  // namespace

std::vector<Example> protocolExamples() {
  const auto bytes = [](const auto& range) { return std::vector<std::uint8_t>(range.begin(), range.end()); };
  const Key session7 = deriveSessionKey(kLongTerm7, {kHostNonce, kBoot, 1});
  const Key session9 = deriveSessionKey(kLongTerm9, {0x01020304, 5, 2});
  Identity identity{kHostNonce, kBoot, 1, kProtocolVersion, 0, 1, 0, 1, 3, 2};

  CycleWriter drive{10, kHostCounter + 1};
  drive.add({7, CommandMode::Drive, 120, kBearing, 25, 0}, session7);
  CycleWriter two{10, kHostCounter + 2};
  two.add({9, CommandMode::Stop, 0, 0, 0, 17}, session9);
  two.add({7, CommandMode::Poll, 0, 0, 0, 1}, session7);
  CycleWriter probe{10, kHostCounter + 6};
  probe.add({7, CommandMode::Poll, 0, 0, 0, 0}, kLongTerm7);

  constexpr std::string_view checkText = "123456789";
  const std::uint16_t check = crc16({reinterpret_cast<const std::uint8_t*>(checkText.data()), checkText.size()});
  const auto get = static_cast<std::uint8_t>(Parameter::WheelDiameter);
  const auto set = static_cast<std::uint8_t>(Parameter::MaxSpeed);
  const auto act = static_cast<std::uint8_t>(Action::CalibrateCompass);
  const auto sample = static_cast<std::uint8_t>(static_cast<std::uint8_t>(Parameter::CompassSample) + 32);
  constexpr auto u16 = [](std::uint32_t v) { return static_cast<std::uint16_t>(v); };
  return {
      {"crc", {static_cast<std::uint8_t>(check), static_cast<std::uint8_t>(check >> 8)}},
      {"session-key", bytes(session7)},
      {"session-key-9", bytes(session9)},
      {"hello", sealed(kLongTerm7, 0, true, MessageType::Hello, Hello{kHostNonce, kHostCounter})},
      {"identity", sealed(kLongTerm7, 0, false, MessageType::Identity, identity)},
      {"cycle-drive", finished(drive)},
      {"report-driving", sealed(session7, 1, false, MessageType::Report, reportDriving())},
      {"cycle-two", finished(two)},
      {"report-later", sealed(session7, 2, false, MessageType::Report, reportLater())},
      {"get", sealed(session7, kHostCounter + 3, true, MessageType::Get, Request{MessageType::Get, get, 0})},
      {"value-get",
       sealed(session7, 3, false, MessageType::Value, Value{u16(kHostCounter + 3), get, Outcome::Done, 100'000})},
      {"set", sealed(session7, kHostCounter + 4, true, MessageType::Set, Request{MessageType::Set, set, 300})},
      {"value-set",
       sealed(session7, 4, false, MessageType::Value, Value{u16(kHostCounter + 4), set, Outcome::Done, 300})},
      {"do", sealed(session7, kHostCounter + 5, true, MessageType::Do, Request{MessageType::Do, act, 0})},
      {"value-do",
       sealed(session7, 5, false, MessageType::Value, Value{u16(kHostCounter + 5), act, Outcome::Started, 0})},
      {"get-sample", sealed(session7, kHostCounter + 7, true, MessageType::Get, Request{MessageType::Get, sample, 0})},
      {"value-sample", sealed(session7, 6, false, MessageType::Value,
                              Value{u16(kHostCounter + 7), sample, Outcome::Done, packCompass({880, -1976})})},
      {"pair", sealed(session7, kPairCounter, true, MessageType::Pair,
                      makePair(kLongTerm7, kNew7, {{kHostNonce, kBoot, 1}, kPairCounter}))},
      {"paired", sealed(kNew7, 0, false, MessageType::Paired, Paired{kHostNonce, kPairCounter, Outcome::Done})},
      {"cycle-probe", finished(probe)},
      {"hail", sealed(kLongTerm7, 0, false, MessageType::Hail,
                      Hail{kBoot + 1, static_cast<std::uint8_t>(ResetCause::Watchdog)})},
  };
}

}  // namespace tessera::wire
