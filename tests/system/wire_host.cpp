#include "system/wire_host.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <QDeadlineTimer>
#include <algorithm>
#include <array>

namespace tessera::system_test {

using wire::MessageType;

WireHost::WireHost(const std::string& port, const floor::VehicleSetup& vehicle)
    : port_{::open(port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)}, vehicle_{vehicle} {}

WireHost::~WireHost() { ::close(port_); }

void WireHost::say(const std::vector<std::uint8_t>& frame) const {
  [[maybe_unused]] const auto written = ::write(port_, frame.data(), frame.size());
}

std::optional<std::vector<std::uint8_t>> WireHost::hear(MessageType type, const wire::Key& key, int milliseconds) {
  std::optional<std::vector<std::uint8_t>> found;
  const QDeadlineTimer end{milliseconds};
  while (!found && !end.hasExpired()) {
    pollfd ready{port_, POLLIN, 0};
    if (::poll(&ready, 1, 20) <= 0) continue;
    std::array<std::uint8_t, 256> bytes{};
    const ssize_t size = ::read(port_, bytes.data(), bytes.size());
    if (size <= 0) continue;
    decoder_.feed(wire::Bytes{bytes}.first(static_cast<std::size_t>(size)), [&](const wire::Frame& frame) {
      const auto sealed = wire::splitMac(frame.payload);
      if (!sealed || frame.header.type != static_cast<std::uint8_t>(type) || frame.header.from != vehicle_.id.value)
        return;
      const std::uint32_t counter = type == MessageType::Report ? ++reports_ : 0;
      if (wire::sameMac(wire::macOf(key, counter, frame.header, sealed->body), sealed->mac))
        found = std::vector<std::uint8_t>(sealed->body.begin(), sealed->body.end());
    });
  }
  return found;
}

std::optional<wire::Identity> WireHost::call() {
  std::array<std::uint8_t, 8> body{};
  wire::encode(wire::Hello{++nonce_, counter_}, body);
  std::vector<std::uint8_t> frame(wire::kMaxFrame);
  const wire::FrameHeader header{vehicle_.id.value, 0, static_cast<std::uint8_t>(MessageType::Hello), 0};
  frame.resize(wire::sealFrame(vehicle_.key, 0, header, body, frame));
  for (int tries = 0; tries < 60; ++tries) {
    say(frame);
    const auto heard = hear(MessageType::Identity, vehicle_.key, 500);
    const auto identity = heard ? wire::decodeIdentity(*heard) : std::nullopt;
    if (!identity || identity->hostNonce != nonce_) continue;
    session_ = wire::deriveSessionKey(vehicle_.key, {nonce_, identity->boot, identity->hello});
    reports_ = 0;
    return identity;
  }
  return std::nullopt;
}

std::vector<std::uint8_t> WireHost::command(wire::CommandMode mode, std::int16_t speed) {
  wire::CycleWriter writer{0, ++counter_};
  wire::CycleEntry entry;
  entry.vehicle = vehicle_.id.value;
  entry.mode = mode;
  entry.speed = speed;
  entry.expiry = 50;
  writer.add(entry, session_);
  std::vector<std::uint8_t> frame(wire::kMaxFrame);
  frame.resize(writer.finish(frame));
  return frame;
}

std::optional<wire::Report> WireHost::report() {
  const auto heard = hear(MessageType::Report, session_, 10'000);
  return heard ? wire::decodeReport(*heard) : std::nullopt;
}

}  // namespace tessera::system_test
