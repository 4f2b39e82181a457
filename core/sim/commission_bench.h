// An integrator's bench: one vehicle on a cable instead of the air, and a host's end of the protocol on it, in virtual
// time. It speaks the frames that every host speaks; it sees nothing of the vehicle but the bytes of its UART.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "base/units.h"
#include "sim/vehicle_body.h"
#include "wire/frame.h"
#include "wire/messages.h"
#include "wire/security.h"

namespace tessera::sim {

class CommissionBench {
public:
  /// The vehicle must outlive the bench and have been started at `now`.
  CommissionBench(VehicleBody& vehicle, const wire::Key& key, Seconds now) : vehicle_{vehicle}, key_{key}, now_{now} {}

  [[nodiscard]] Seconds now() const { return now_; }
  /// Lets time pass, in steps of 1 ms.
  void run(Seconds time);
  /// Lets time pass until `done` says so; false when `patience` ran out first.
  bool runUntil(const std::function<bool()>& done, Seconds patience);

  /// Hello until the vehicle answers. Error: it did not, for five seconds.
  [[nodiscard]] Result<wire::Identity> open();
  /// One command and the report that answers it; nullopt when none came within 100 ms.
  std::optional<wire::Report> command(const wire::CycleEntry& entry);
  std::optional<wire::Report> poll() { return command({}); }
  /// Commands that are repeated each 100 ms for a time. Returns the last report.
  std::optional<wire::Report> keepCommanding(const wire::CycleEntry& entry, Seconds time);
  /// Get, Set or Do, and the answer.
  std::optional<wire::Value> request(const wire::Request& request);
  /// Bytes straight onto the cable, for tests of what a vehicle refuses.
  void send(std::span<const std::uint8_t> bytes) { vehicle_.giveRadioBytes(bytes); }
  /// The last frame that the bench sent, byte by byte.
  [[nodiscard]] const std::vector<std::uint8_t>& lastSent() const { return lastSent_; }

private:
  void step();
  void answerAsModule(std::span<const std::uint8_t> bytes);
  void take(const wire::Frame& frame);
  void transmit(wire::MessageType type, const wire::Key& key, std::uint32_t counter, wire::Bytes body);
  [[nodiscard]] bool fromVehicle(const wire::Frame& frame, const wire::Sealed& sealed);

  VehicleBody& vehicle_;
  wire::Key key_;
  Seconds now_;
  wire::FrameDecoder decoder_;
  std::array<std::uint8_t, 6> moduleRegisters_{0xC0, 0x00, 0x00, 0x1A, 0x17, 0x44};  // as E32 modules are delivered
  std::vector<std::uint8_t> toModule_;
  std::uint32_t hostNonce_ = 0x10000000;
  std::uint32_t counter_ = 0;
  std::optional<wire::Key> sessionKey_;
  wire::ReplayGuard guard_;
  std::optional<wire::Identity> identity_;
  std::optional<wire::Report> report_;
  std::optional<wire::Value> value_;
  std::vector<std::uint8_t> lastSent_;
};

}  // namespace tessera::sim
