#include "firmware/vehicle/vehicle.h"

#include <algorithm>
#include <array>

namespace tessera::firmware {
namespace {

constexpr int kBatteryHysteresis = 200;  // mV

}  // namespace

Vehicle::Vehicle(Board& board) : board_{board}, store_{board}, radio_{board}, readers_{board}, pilot_{board} {}

void Vehicle::poll() {
  const Micros now = clock_.update(board_.micros());
  polled_ = true;
  store_.poll(now);
  if (!store_.ready()) return;
  if (!started_) start(now);
  radio_.poll(now, [&](const wire::Frame& frame) { hear(session_.receive(frame, now), now); });
  if (const auto reading = readers_.poll(now)) tags_.take(*reading, now);
  carryPairingOn(now);
  reply(now);
  restartWhenDue(now);
}

void Vehicle::tick() {
  const std::uint32_t begin = board_.micros();
  const Micros now = clock_.update(begin);
  if (started_) {
    pilot_.forbid(!store_.found());
    pilot_.tick(now);
    keepCalibration();
    longestTick_ = std::max(longestTick_, board_.micros() - begin);
  }
  if (polled_) board_.feedWatchdog();
  polled_ = false;
}

void Vehicle::start(Micros now) {
  const Settings& settings = store_.settings();
  Person person;
  person.address = static_cast<std::uint8_t>(settings.get(wire::Parameter::Address));
  person.key = settings.key;
  person.starts = store_.starts();
  person.cause = board_.resetCause();
  person.hardware = board_.hardware();
  person.readers = static_cast<std::uint8_t>(settings.get(wire::Parameter::ReaderCount));
  person.rangers = kRangers;
  session_.start(person);
  if (person.cause == wire::ResetCause::Watchdog) pilot_.latch(wire::kFaultWatchdog);
  radio_.start(settings, now);
  use(settings);
  started_ = true;
}

void Vehicle::hear(const Heard& heard, Micros now) {
  session_.stir(pilot_.noise());
  if (heard.newSession) tags_.beginSession(now);
  switch (heard.kind) {
    case Heard::Kind::Nothing:
      break;
    case Heard::Kind::Entry:
      tags_.acknowledge(heard.entry.nextEvent);
      pilot_.take(heard.entry, now);
      break;
    case Heard::Kind::Request:
      handle(heard.request, now);
      break;
    case Heard::Kind::Pair:
      pair(heard, now);
      break;
  }
}

void Vehicle::reply(Micros now) {
  if (!radio_.canSend()) return;
  std::array<std::uint8_t, wire::kMaxFrame> out{};
  std::size_t size = 0;
  switch (session_.due(now)) {
    case Owed::Nothing:
      return;
    case Owed::Identity:
      size = session_.writeIdentity(out);
      break;
    case Owed::Hail:
      size = session_.writeHail(out);
      break;
    case Owed::Report:
      size = session_.writeReport(report(now), now, out);
      break;
    case Owed::Value:
      size = session_.writeValue(out);
      break;
    case Owed::Paired:
      size = session_.writePaired(out);
      break;
  }
  radio_.send(wire::Bytes{out}.first(size));
}

wire::Report Vehicle::report(Micros now) {
  wire::Report r;
  r.faults = faults();
  tags_.fill(r, now);
  r.state = pilot_.state();
  r.clock = static_cast<std::uint16_t>(now.count() / 1000);
  r.speed = static_cast<std::int16_t>(std::lround(std::clamp(pilot_.speed() * 1000.0F, -32000.0F, 32000.0F)));
  r.travel = pilot_.travel();
  r.bearing = toBinaryAngle(pilot_.bearing());
  r.battery = static_cast<std::uint8_t>(std::clamp((readers_.batteryMillivolts() + 50) / 100, 0, 255));
  r.range = pilot_.rangeCm();
  r.readers = readers_.answering();
  return r;
}

std::uint16_t Vehicle::faults() {
  const int low = store_.settings().get(wire::Parameter::BatteryLow);
  const int battery = readers_.batteryMillivolts();
  if (battery > 0) batteryLow_ = battery < low + (batteryLow_ ? kBatteryHysteresis : 0);
  std::uint16_t faults = pilot_.faults() | session_.faults();
  if (readers_.faulty()) faults |= wire::kFaultReader;
  if (batteryLow_) faults |= wire::kFaultBattery;
  if (store_.faulty()) faults |= wire::kFaultEeprom;
  if (radio_.faulty()) faults |= wire::kFaultRadio;
  if (tags_.lost()) faults |= wire::kFaultEventsLost;
  return faults;
}

}  // namespace tessera::firmware
