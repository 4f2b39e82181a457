// A channel, its air and its vehicles, with the events sorted by kind.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "link/channel.h"
#include "link/fake_air.h"

namespace tessera::test {

inline wire::Key keyOf(std::uint8_t vehicle) {
  wire::Key key{};
  for (std::size_t i = 0; i < key.size(); ++i) key[i] = static_cast<std::uint8_t>(17 * vehicle + i);
  return key;
}

class ChannelRig {
public:
  explicit ChannelRig(std::uint8_t vehicles, FakeAir::Options options = {}, Seconds silentAfter = Seconds{1.0}) {
    link::ChannelConfig config;
    config.airRate = options.airRate;
    config.baud = options.baud;
    config.nonceSeed = 42;
    config.silentAfter = silentAfter;
    std::vector<FakeVehicle*> all;
    for (std::uint8_t id = 1; id <= vehicles; ++id) {
      config.vehicles.push_back({VehicleId{id}, keyOf(id)});
      fakes.push_back(std::make_unique<FakeVehicle>(id, keyOf(id)));
      all.push_back(fakes.back().get());
    }
    channel = std::make_unique<link::Channel>(config);
    air = std::make_unique<FakeAir>(all, options);
    host.ingest = [this](wire::Bytes b, Seconds t) { channel->ingest(b, t); };
    host.poll = [this](Seconds t) {
      auto out = channel->poll(t);
      for (auto& e : out.events) events.push_back(std::move(e));
      return std::pair{out.bytes, std::min(out.wake, t + askEvery)};
    };
    channel->opened(air->now);
  }

  void run(Seconds span) { air->run(host, air->now + span); }
  /// False: it did not happen within `limit`.
  bool runUntil(const std::function<bool()>& condition, Seconds limit) {
    air->run(host, air->now + limit, [&](Seconds) { return condition(); });
    return condition();
  }
  template <class E>
  [[nodiscard]] std::vector<E> all() const {
    std::vector<E> found;
    for (const auto& e : events)
      if (const auto* hit = std::get_if<E>(&e)) found.push_back(*hit);
    return found;
  }
  template <class E>
  [[nodiscard]] std::size_t count() const {
    return all<E>().size();
  }
  [[nodiscard]] FakeVehicle& fake(std::uint8_t id) { return *fakes.at(id - 1U); }
  [[nodiscard]] const link::Peer& peer(std::uint8_t id) const { return *channel->peer(VehicleId{id}); }
  [[nodiscard]] bool connected() const {
    for (const auto& f : fakes)
      if (!channel->peer(VehicleId{f->address})->connected()) return false;
    return true;
  }
  void drive(std::uint8_t id) {
    channel->wish(VehicleId{id}, {wire::CommandMode::Drive, MetresPerSecond{0.1}, 0, Seconds{0.6}});
  }

  std::vector<std::unique_ptr<FakeVehicle>> fakes;
  std::unique_ptr<link::Channel> channel;
  std::unique_ptr<FakeAir> air;
  FakeAir::Host host;
  Seconds askEvery{link::kNever};  ///< polls more often than the channel asks for
  std::vector<link::LinkEvent> events;
};

}  // namespace tessera::test
