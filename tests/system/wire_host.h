// A host of a few lines on a port, for tests that look at what is said: calls a vehicle, commands it, repeats frames.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "floor/site.h"
#include "wire/messages.h"

namespace tessera::system_test {

class WireHost {
public:
  WireHost(const std::string& port, const floor::VehicleSetup& vehicle);
  ~WireHost();
  WireHost(const WireHost&) = delete;
  WireHost& operator=(const WireHost&) = delete;

  /// Calls until the vehicle answers; a session stands then.
  std::optional<wire::Identity> call();
  /// A Cycle for this vehicle alone under the next counter, as bytes.
  [[nodiscard]] std::vector<std::uint8_t> command(wire::CommandMode mode, std::int16_t speed = 0);
  void say(const std::vector<std::uint8_t>& frame) const;
  /// The next genuine report of this session; nullopt: none came within ten seconds.
  std::optional<wire::Report> report();

private:
  /// The next frame of this type within a time, its body without the MAC.
  std::optional<std::vector<std::uint8_t>> hear(wire::MessageType type, const wire::Key& key, int milliseconds);

  int port_;
  floor::VehicleSetup vehicle_;
  wire::FrameDecoder decoder_;
  wire::Key session_{};
  std::uint32_t nonce_ = 0x5E55;
  std::uint32_t counter_ = 100;
  std::uint32_t reports_ = 0;
};

}  // namespace tessera::system_test
