#include "link/channel.h"

#include <algorithm>
#include <cmath>

namespace tessera::link {
namespace {

constexpr Seconds kAnswerGuard{0.010};  // the vehicle's and our own sluggishness
constexpr Seconds kStale{
    0.060};  // a pause this long inside a frame means that its rest is lost; a busy machine makes shorter ones

}  // namespace

Channel::Channel(const ChannelConfig& config)
    : timing_{config.airRate, config.baud},
      schedule_{config.idlePeriod},
      nonces_{config.nonceSeed},
      silentAfter_{config.silentAfter} {
  peers_.reserve(config.vehicles.size());
  for (const ChannelConfig::Vehicle& v : config.vehicles) peers_.emplace_back(v.id, v.key, v.offered);
}

void Channel::opened(Seconds now) {
  open_ = true;
  flight_.reset();
  // Half a frame from before is nobody's fault.
  decoder_.flush([](const wire::Frame&) {});
  told_ = decoder_.counters();
  for (Peer& peer : peers_) {
    peer.quietSince = now;
    peer.calls.reset(now);
  }
}

void Channel::closed() {
  open_ = false;
  flight_.reset();
}

const Peer* Channel::peer(VehicleId vehicle) const {
  const auto index = indexOf(vehicle);
  return index ? &peers_[*index] : nullptr;
}

std::optional<std::size_t> Channel::indexOf(VehicleId vehicle) const {
  for (std::size_t i = 0; i < peers_.size(); ++i)
    if (peers_[i].session.vehicle() == vehicle) return i;
  return std::nullopt;
}

void Channel::wish(VehicleId vehicle, const Wish& wish) {
  if (const auto index = indexOf(vehicle)) peers_[*index].wishFor(wish);
}

Seconds Channel::cyclePeriod() const {
  if (period_) return *period_;
  const double rounds = std::ceil(static_cast<double>(std::max<std::size_t>(peers_.size(), 1)) /
                                  static_cast<double>(timing_.maxEntries()));
  const double entries = std::ceil(static_cast<double>(peers_.size()) / rounds);
  const Seconds slot{timing_.slotUnits() * wire::kSlotUnitMs / 1000.0};
  return rounds * (2.0 * timing_.oneWay(wire::kMaxFrame) + std::max(0.0, entries - 1.0) * slot);
}

Seconds Channel::effectiveAt(Seconds now) const {
  const std::size_t entries =
      std::clamp<std::size_t>(static_cast<std::size_t>(std::count_if(peers_.begin(), peers_.end(),
                                                                     [](const Peer& p) { return p.connected(); })),
                              1, timing_.maxEntries());
  return now + timing_.oneWay(wire::kFrameOverhead + 1 + entries * wire::kCycleEntrySize);
}

// --- what is on the air now -----------------------------------------------------------------------------------------

Seconds Channel::staleAt() const { return lastByte_ + kStale; }

// An answer that has not come is given up at its deadline, one that is just coming a little later.
Seconds Channel::flightEnd() const {
  Seconds end{-1e9};
  for (std::size_t i = 0; i < flight_->count; ++i)
    if (!flight_->answers[i].came) end = std::max(end, flight_->answers[i].deadline);
  if (!decoder_.pending()) return end;
  return std::max(end, std::min(staleAt(), end + timing_.oneWayAtMost(wire::kMaxFrame)));
}

bool Channel::idle(Seconds now) const { return open_ && (!flight_ || now >= flightEnd()); }

void Channel::settle(Seconds now) {
  if (decoder_.pending() && now >= staleAt()) decoder_.flush([this](const wire::Frame& f) { hear(f); });
  if (flight_ && now >= flightEnd()) {
    decoder_.flush([this](const wire::Frame& f) { hear(f); });
    closeFlight();
  }
}

void Channel::closeFlight() {
  const Flight flight = *flight_;
  flight_.reset();
  for (std::size_t i = 0; i < flight.count; ++i) {
    if (flight.answers[i].came || flight.kind != Turn::Kind::Cycle) continue;
    Peer& peer = peers_[flight.answers[i].peer];
    peer.quality.unanswered();
    events_.emplace_back(CommandUnanswered{peer.session.vehicle(), flight.counter});
    timing_.missed();
  }
  if (flight.kind == Turn::Kind::Request && !flight.answers[0].came) closeRequest();
}

void Channel::watchSilence(Seconds now) {
  const Seconds limit = std::max(silentAfter_, 4.0 * cyclePeriod());
  for (Peer& peer : peers_) {
    if (!peer.connected() || !peer.quietSince || now - *peer.quietSince < limit) continue;
    peer.silent = true;
    peer.callsMade = 0;
    peer.calls.reset(now);
    events_.emplace_back(Silent{peer.session.vehicle(), *peer.quietSince});
  }
}

// --- sending
// ----------------------------------------------------------------------------------------------------------

Channel::Output Channel::poll(Seconds now) {
  Output out;
  if (open_) {
    settle(now);
    tellNoise();
    watchSilence(now);
    dropHopelessRequests();
    if (!flight_) {
      const Turn turn = schedule_.next(peers_, timing_.maxEntries(), !requests_.empty(), now);
      std::array<std::uint8_t, wire::kMaxFrame> frame{};
      std::size_t size = 0;
      switch (turn.kind) {
        case Turn::Kind::Nothing:
          out.wake = turn.wake;
          break;
        case Turn::Kind::Call:
          size = sendCall(turn, now, frame);
          break;
        case Turn::Kind::Probe:
        case Turn::Kind::Cycle:
          size = sendCycle(turn, now, frame);
          break;
        case Turn::Kind::Request:
          size = sendRequest(now, frame);
          break;
      }
      out.bytes.assign(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size));
    }
    if (flight_) out.wake = flightEnd();
    if (decoder_.pending()) out.wake = std::min(out.wake, staleAt());
  }
  out.events.swap(events_);
  return out;
}

void Channel::departed(Turn::Kind kind, std::span<const std::size_t> peers, std::size_t bytes, Seconds slot,
                       Seconds now) {
  Flight flight;
  flight.kind = kind;
  flight.counter = counter_;
  flight.count = peers.size();
  Seconds deadline = now + timing_.oneWayAtMost(bytes) + timing_.oneWayAtMost(wire::kMaxFrame) + kAnswerGuard;
  for (std::size_t i = 0; i < peers.size(); ++i) {
    flight.answers[i] = {peers[i], deadline, false};
    deadline += slot;
  }
  flight_ = flight;
  // Calls are not timed: their answers do not tell how long the vehicle held them, and they use no counter.
  if (kind != Turn::Kind::Call) departures_[departureCount_++ % departures_.size()] = {counter_, now, bytes};
}

std::size_t Channel::sendCall(const Turn& turn, Seconds now, std::span<std::uint8_t> out) {
  Peer& peer = peers_[turn.peers[0]];
  const std::uint32_t nonce = nonces_.next();
  const std::size_t size = peer.session.hello(nonce, counter_, out);
  peer.calls.failed(now);
  ++peer.callsMade;
  peer.called.sent({nonce, size, now});
  departed(Turn::Kind::Call, std::span{turn.peers}.first(1), size, Seconds{}, now);
  return size;
}

std::size_t Channel::sendCycle(const Turn& turn, Seconds now, std::span<std::uint8_t> out) {
  const auto slot = static_cast<std::uint8_t>(std::min(timing_.slotUnits(), 255U));
  wire::CycleWriter writer{slot, ++counter_};
  const bool probe = turn.kind == Turn::Kind::Probe;
  const std::span<const std::size_t> chosen = std::span{turn.peers}.first(turn.count);
  const std::size_t size = wire::kFrameOverhead + 1 + turn.count * wire::kCycleEntrySize;
  for (const std::size_t i : chosen) {
    Peer& peer = peers_[i];
    wire::CycleEntry entry;
    entry.vehicle = peer.session.vehicle().value;
    entry.nextEvent = peer.tags.next();
    if (!probe) {
      entry.mode = peer.wish.mode;
      if (entry.mode == wire::CommandMode::Drive) {
        entry.speed = static_cast<std::int16_t>(std::lround(std::clamp(peer.wish.speed.value(), -32.0, 32.0) * 1000));
        entry.bearing = peer.wish.bearing;
        const double units = std::ceil(peer.wish.expiry.value() * 1000 / wire::kExpiryUnitMs);
        entry.expiry = static_cast<std::uint8_t>(std::clamp(units, 0.0, 255.0));
      }
      if (peer.urgent) ++peer.urgentTries;
      if (peer.lastCycle) {
        const Seconds gap = now - *peer.lastCycle;
        period_ = period_ ? *period_ + 0.25 * (gap - *period_) : gap;
      }
      peer.lastCycle = now;
      peer.commands.sent(counter_, entry.mode);
      events_.emplace_back(CommandSent{peer.session.vehicle(), entry, counter_, now, now + timing_.oneWay(size)});
    } else {
      peer.calls.failed(now);
      ++peer.callsMade;
    }
    writer.add(entry, peer.session.key());
  }
  departed(turn.kind, chosen, writer.finish(out), Seconds{slot * wire::kSlotUnitMs / 1000.0}, now);
  return size;
}

}  // namespace tessera::link
