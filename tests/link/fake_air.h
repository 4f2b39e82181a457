// A shared half-duplex channel between one host port and several fake vehicles, by the E32's timing, with losses and
// delays from a seed. It runs from event to event, without a clock, and notes whenever two transmissions overlap.
#pragma once

#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "link/fake_vehicle.h"
#include "wire/airtime.h"

namespace tessera::test {

class FakeAir {
public:
  struct Options {
    double airRate = 19200;
    int baud = 115200;
    double factor = 1.8;
    double loss = 0.0;
    Seconds jitter{0.0};  ///< each packet is delayed by 0 to this much
    std::uint32_t seed = 1;
    Seconds delayThere{0.0};  ///< to the vehicles, after each packet's end: the air is free meanwhile
    Seconds delayBack{0.0};
  };
  /// What the host's side looks like to the air.
  struct Host {
    std::function<void(wire::Bytes, Seconds)> ingest;
    /// Returns bytes to write and the instant at which to be asked again.
    std::function<std::pair<std::vector<std::uint8_t>, Seconds>(Seconds)> poll;
  };
  using Bytes = std::vector<std::uint8_t>;

  FakeAir(std::vector<FakeVehicle*> vehicles, const Options& options)
      : vehicles_{std::move(vehicles)}, options_{options}, random_{options.seed} {}

  /// Runs until `end`; `each` is called after every step and ends the run by returning true.
  void run(Host& host, Seconds end, const std::function<bool(Seconds)>& each = {}) {
    while (true) {
      auto [bytes, wake] = host.poll(now);
      if (!bytes.empty()) {
        hostFrames.push_back({now, bytes});
        transmit(bytes, now, nullptr);
      }
      if (each && each(now)) return;
      Seconds next = std::min(wake, end);
      if (!arrivals_.empty()) next = std::min(next, arrivals_.begin()->first);
      if (next >= end && (arrivals_.empty() || arrivals_.begin()->first >= end)) {
        now = end;
        return;
      }
      now = std::max(next, now + Seconds{1e-6});
      while (!arrivals_.empty() && arrivals_.begin()->first <= now) {
        const Arrival arrival = arrivals_.begin()->second;
        const Seconds at = arrivals_.begin()->first;
        arrivals_.erase(arrivals_.begin());
        if (arrival.toHost)
          host.ingest(arrival.bytes, at);
        else
          deliver(arrival.bytes, at);
      }
    }
  }

  /// Puts bytes before the host as if they came over the air just now.
  void inject(const Bytes& bytes, Seconds at) { arrivals_.emplace(at, Arrival{true, bytes}); }
  void injectToVehicles(const Bytes& bytes, Seconds at) { arrivals_.emplace(at, Arrival{false, bytes}); }

  Seconds now{10.0};
  Options& options() { return options_; }
  std::vector<std::pair<Seconds, Bytes>> hostFrames;
  std::vector<std::pair<Seconds, Bytes>> vehicleFrames;  ///< as they would reach the host
  unsigned overlaps = 0;
  /// Changes a frame on its way to the host; empty: lost.
  std::function<Bytes(Bytes)> tamper;

private:
  struct Arrival {
    bool toHost;
    Bytes bytes;
  };

  void transmit(const Bytes& bytes, Seconds written, const FakeVehicle* sender) {
    const Seconds uart{10.0 * static_cast<double>(bytes.size()) / options_.baud};
    const Seconds jitter = std::uniform_real_distribution<>{0.0, 1.0}(random_)*options_.jitter;
    const Seconds begin = written + uart + Seconds{30.0 / options_.baud} + jitter;
    const Seconds end = begin + Seconds{options_.factor * wire::loRaAirtime(bytes.size(), options_.airRate)};
    if (begin < busyUntil_) ++overlaps;
    busyUntil_ = std::max(busyUntil_, end);
    const Seconds delay = sender != nullptr ? options_.delayBack : options_.delayThere;
    const Seconds arrival = end + delay + Seconds{0.005} + uart;
    if (sender != nullptr) vehicleFrames.push_back({arrival, bytes});
    if (std::bernoulli_distribution{options_.loss}(random_)) return;
    Bytes heard = sender != nullptr && tamper ? tamper(bytes) : bytes;
    if (!heard.empty()) arrivals_.emplace(arrival, Arrival{sender != nullptr, heard});
  }

  void deliver(const Bytes& bytes, Seconds at) {
    for (FakeVehicle* vehicle : vehicles_) {
      wire::FrameDecoder decoder;
      decoder.feed(bytes, [&](const wire::Frame& frame) {
        const auto answer = vehicle->hear(frame, at);
        if (answer) pending_.emplace(at + answer->delay, std::pair{vehicle, answer->bytes});
      });
    }
    while (!pending_.empty()) {
      const auto [when, what] = *pending_.begin();
      pending_.erase(pending_.begin());
      transmit(what.second, when, what.first);
    }
  }

  std::vector<FakeVehicle*> vehicles_;
  Options options_;
  std::mt19937 random_;
  Seconds busyUntil_{0.0};
  std::multimap<Seconds, Arrival> arrivals_;
  std::multimap<Seconds, std::pair<FakeVehicle*, Bytes>> pending_;
};

}  // namespace tessera::test
