// The vehicle's own program in the emulated microcontroller: it starts, sets up its radio, tells who it is, drives and
// stops by itself.
#include <algorithm>
#include <fstream>
#include <optional>

#include "emulated_board.h"
#include "firmware/vehicle/radio.h"
#include "firmware/vehicle/settings.h"
#include "wire/messages.h"
#include "wire/pairing.h"
#include "wire/security.h"

namespace tessera::sim {
namespace {

constexpr std::uint8_t kAddress = 7;
constexpr Seconds kExpiry{0.5};  // of every command
constexpr wire::Key kKey = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};

class QemuVehicle : public EmulatedBoard {
protected:
  QemuVehicle() : EmulatedBoard{VEHICLE_ELF} {
    settings_.key = kKey;
    settings_.set(wire::Parameter::Address, kAddress);
    const auto image = firmware::makeEepromImage(settings_);
    std::ofstream file{directory_ / "eeprom.bin", std::ios::binary};
    file.write(reinterpret_cast<const char*>(image.data()), static_cast<std::streamsize>(image.size()));
    Signals signals;
    signals.field = {80.0, 60.0, 40.0};
    host_.setSignals(signals);
  }

  /// Switches the vehicle on and is its radio module while it asks for the module's parameters.
  void startVehicle() {
    const auto started = host_.start(Seconds{});
    ASSERT_TRUE(started) << started.error().sentence;
    heard_.clear();
    ASSERT_TRUE(eventually([&] {
      collect();
      return mode_ == firmware::RadioMode::Configure && heard_.ends_with("\xC1\xC1\xC1");
    })) << "the vehicle does not ask its radio module";
    heard_.clear();
    host_.fromRadio(firmware::radioRegisters(settings_));
    ASSERT_TRUE(eventually([&] {
      collect();
      return mode_ == firmware::RadioMode::Normal;
    }));
  }

  /// Sends `frame` until a frame of `type` answers; its payload, empty when none came.
  std::vector<std::uint8_t> exchange(std::span<const std::uint8_t> frame, wire::MessageType type) {
    std::vector<std::uint8_t> payload;
    int asked = 0;
    EXPECT_TRUE(eventually([&] {
      if (asked++ % 200 == 0) host_.fromRadio(frame);
      for (std::uint8_t byte : host_.take().toRadio) {
        decoder_.feed(wire::Bytes{&byte, 1}, [&](const wire::Frame& answer) {
          if (answer.header.type == static_cast<std::uint8_t>(type) && answer.header.from == kAddress)
            payload.assign(answer.payload.begin(), answer.payload.end());
        });
      }
      return !payload.empty();
    })) << "no answer of type "
        << static_cast<int>(type);
    return payload;
  }

  /// Opens a session; the vehicle's Identity.
  wire::Identity meet(std::uint32_t nonce) {
    std::array<std::uint8_t, wire::kMaxPayload> body{};
    std::array<std::uint8_t, wire::kMaxFrame> frame{};
    const std::size_t n = wire::encode(wire::Hello{nonce, 0}, body);
    const wire::FrameHeader header{kAddress, wire::kHostAddress, static_cast<std::uint8_t>(wire::MessageType::Hello),
                                   0};
    const std::size_t size = wire::sealFrame(key_, 0, header, std::span{body}.first(n), frame);
    const auto payload = exchange(std::span{frame}.first(size), wire::MessageType::Identity);
    const auto sealed = wire::splitMac(payload);
    const auto identity = sealed ? wire::decodeIdentity(sealed->body) : std::nullopt;
    EXPECT_TRUE(identity);
    if (!identity) return {};
    session_ = wire::deriveSessionKey(key_, {nonce, identity->boot, identity->hello});
    return *identity;
  }

  wire::Report command(wire::CommandMode mode, std::int16_t speed = 0, std::uint16_t bearing = 0) {
    wire::CycleWriter cycle{1, ++counter_};
    wire::CycleEntry entry;
    entry.vehicle = kAddress;
    entry.mode = mode;
    entry.speed = speed;
    entry.bearing = bearing;
    entry.expiry = static_cast<std::uint8_t>(kExpiry.value() * 1000 / wire::kExpiryUnitMs);
    cycle.add(entry, session_);
    std::array<std::uint8_t, wire::kMaxFrame> frame{};
    const std::size_t size = cycle.finish(frame);
    const auto payload = exchange(std::span{frame}.first(size), wire::MessageType::Report);
    const auto sealed = wire::splitMac(payload);
    const auto report = sealed ? wire::decodeReport(sealed->body) : std::nullopt;
    EXPECT_TRUE(report);
    return report.value_or(wire::Report{});
  }

  /// Gives it another key. True: it answers under that key, which is used from now on.
  bool pair(const wire::Key& fresh, const wire::Identity& identity) {
    std::array<std::uint8_t, wire::kMaxPayload> body{};
    std::array<std::uint8_t, wire::kMaxFrame> frame{};
    const wire::PairingNonce nonce{{identity.hostNonce, identity.boot, identity.hello}, ++counter_};
    const std::size_t n = wire::encode(wire::makePair(key_, fresh, nonce), body);
    const wire::FrameHeader header{kAddress, wire::kHostAddress, static_cast<std::uint8_t>(wire::MessageType::Pair), 0};
    const std::size_t size = wire::sealFrame(session_, counter_, header, std::span{body}.first(n), frame);
    const auto payload = exchange(std::span{frame}.first(size), wire::MessageType::Paired);
    const auto sealed = wire::splitMac(payload);
    const auto paired = sealed ? wire::decodePaired(sealed->body) : std::nullopt;
    const wire::FrameHeader back{wire::kHostAddress, kAddress, static_cast<std::uint8_t>(wire::MessageType::Paired), 0};
    key_ = fresh;
    return paired == wire::Paired{identity.hostNonce, nonce.counter, wire::Outcome::Done} &&
           wire::sameMac(wire::macOf(fresh, 0, back, sealed->body), sealed->mac);
  }

  std::int32_t get(wire::Parameter parameter) {
    std::array<std::uint8_t, wire::kMaxPayload> body{};
    std::array<std::uint8_t, wire::kMaxFrame> frame{};
    const std::size_t n =
        wire::encode(wire::Request{wire::MessageType::Get, static_cast<std::uint8_t>(parameter), 0}, body);
    const wire::FrameHeader header{kAddress, wire::kHostAddress, static_cast<std::uint8_t>(wire::MessageType::Get), 0};
    const std::size_t size = wire::sealFrame(session_, ++counter_, header, std::span{body}.first(n), frame);
    const auto payload = exchange(std::span{frame}.first(size), wire::MessageType::Value);
    const auto sealed = wire::splitMac(payload);
    const auto value = sealed ? wire::decodeValue(sealed->body) : std::nullopt;
    EXPECT_TRUE(value && value->outcome == wire::Outcome::Done);
    return value ? value->value : 0;
  }

  firmware::Settings settings_;
  wire::FrameDecoder decoder_;
  wire::Key key_ = kKey;
  wire::Key session_{};
  std::uint32_t counter_ = 0;
};

TEST_F(QemuVehicle, tellsWhoItIsAndCountsItsStarts) {
  startVehicle();
  const wire::Identity identity = meet(0xABCD0123);
  EXPECT_EQ(identity.hostNonce, 0xABCD0123U);
  EXPECT_EQ(identity.hardware, 1);
  EXPECT_EQ(identity.readers, 3);
  EXPECT_EQ(identity.rangers, 2);
  host_.kill();
  startVehicle();
  EXPECT_EQ(meet(5).boot, identity.boot + 1) << "the EEPROM keeps the count";
}

TEST_F(QemuVehicle, takesAnotherKeyAndHasItAfterAStart) {
  startVehicle();
  const wire::Identity identity = meet(77);
  command(wire::CommandMode::Poll);
  ASSERT_TRUE(pair({0xC0, 0xC1, 0xC2, 0xC3}, identity));
  host_.kill();
  startVehicle();
  EXPECT_EQ(meet(78).boot, identity.boot + 1);
}

TEST_F(QemuVehicle, drivesWhenToldAndStopsByItself) {
  startVehicle();
  meet(1);
  // The first look at the compass takes a moment; until then a heading means nothing.
  wire::Report report;
  EXPECT_TRUE(eventually([&] {
    report = command(wire::CommandMode::Poll);
    return (report.faults & wire::kFaultCompass) == 0;
  }));
  EXPECT_EQ(report.state, wire::VehicleState::Standing);
  command(wire::CommandMode::Drive, 100, report.bearing);
  const auto given = std::chrono::steady_clock::now();  // it had the command before it answered
  EXPECT_TRUE(eventually([&] {
    collect();
    return duty_[0] > 0 && duty_[1] > 0;
  })) << duty_[0]
      << " " << duty_[1];
  EXPECT_TRUE(eventually(
      [&] {
        collect();
        return duty_ == std::array{0, 0};
      },
      kExpiry + Seconds{0.5}))
      << "the command has run out";
  EXPECT_LT(std::chrono::steady_clock::now() - given, std::chrono::duration<double>((kExpiry + Seconds{0.5}).value()));
  const std::int32_t stackFree = get(wire::Parameter::StackFree);
  EXPECT_GT(stackFree, 4096) << "of 8192 bytes";
  EXPECT_LT(stackFree, 8192);
  RecordProperty("stackFree", stackFree);
}

}  // namespace
}  // namespace tessera::sim
