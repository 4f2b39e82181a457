// The receiving half of the channel: what the vehicles' frames change.
#include <algorithm>

#include "link/channel.h"

namespace tessera::link {
namespace {

constexpr unsigned kMaxHold = 60000;  // ms; beyond, the field may have come to its end

template <class... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

}  // namespace

void Channel::ingest(wire::Bytes bytes, Seconds now) {
  if (bytes.empty() || !open_) return;
  // Half a frame is not given up here, however late its rest comes: it may have waited in the port for us. poll() does
  // that, after whoever drives this has looked into the port.
  lastByte_ = now;
  decoder_.feed(bytes, [this](const wire::Frame& f) { hear(f); });
}

void Channel::hear(const wire::Frame& frame) {
  const auto index = indexOf(VehicleId{frame.header.from});
  if (!index || frame.header.to != wire::kHostAddress) {
    ++foreign_;
    return;
  }
  const std::size_t bytes = frame.payload.size() + wire::kFrameOverhead;
  const std::size_t i = *index;
  const VehicleId vehicle = peers_[i].session.vehicle();
  std::visit(Overloaded{
                 [&](Disbelief why) { disbelieve(i, why); },
                 [&](const HeardIdentity& heard) { hearIdentity(i, heard, bytes); },
                 [&](const HeardLate& heard) { timeCall(peers_[i], heard.hostNonce, bytes); },
                 [&](const HeardVersion& heard) {
                   came(i, std::nullopt);
                   events_.emplace_back(WrongVersion{vehicle, heard.protocol});
                 },
                 [&](const HeardHail& heard) { hearHail(i, heard); },
                 [&](const HeardReport& heard) { hearReport(i, heard.report, bytes); },
                 [&](const HeardValue& heard) { hearValue(i, heard.value); },
                 [&](const HeardPaired&) { came(i, std::nullopt); },
             },
             peers_[i].session.hear(frame));
  hearPairing(i);
}

// The answer that the flight waits for; with an acknowledgement only if it is this flight's.
void Channel::came(std::size_t index, std::optional<std::uint16_t> ack) {
  if (!flight_ || (ack && *ack != static_cast<std::uint16_t>(flight_->counter))) return;
  for (std::size_t k = 0; k < flight_->count; ++k)
    if (flight_->answers[k].peer == index) flight_->answers[k].came = true;
}

// Of what is no answer to a call: it answers an earlier probe, or comes from a stranger, and the call's own answer may
// be under way.
void Channel::cameUnlessCalled(std::size_t index) {
  if (flight_ && flight_->kind != Turn::Kind::Call) came(index, std::nullopt);
}

void Channel::hearIdentity(std::size_t index, const HeardIdentity& heard, std::size_t frameBytes) {
  Peer& peer = peers_[index];
  timeCall(peer, heard.identity.hostNonce, frameBytes);
  came(index, std::nullopt);
  peer.silent = false;
  peer.callsMade = 0;
  peer.quietSince = lastByte_;
  peer.lastCycle.reset();
  if (heard.restarted) {
    ++peer.quality.restarts;
    peer.tags.restart();
  }
  // Whatever was ordered before the session has to be acknowledged in it.
  peer.urgent = peer.wish.mode == wire::CommandMode::Stop || peer.wish.mode == wire::CommandMode::Clear;
  peer.urgentTries = 0;
  events_.emplace_back(Identified{peer.session.vehicle(), heard.identity, heard.restarted});
}

// The nonce tells which call it answers, however many have left since. Calls that are repeated faster than answers can
// come are all in vain, as the vehicle drops the session of each for the next one's: from the first answer on, however
// late it was, each is given the time that this one has taken.
void Channel::timeCall(Peer& peer, std::uint32_t nonce, std::size_t frameBytes) {
  if (const auto call = peer.called.answered(nonce)) timing_.called(call->bytes, frameBytes, lastByte_ - call->at);
}

void Channel::hearHail(std::size_t index, const HeardHail& heard) {
  Peer& peer = peers_[index];
  cameUnlessCalled(index);
  peer.silent = false;
  peer.callsMade = 0;
  peer.calls.reset(lastByte_);
  if (heard.restarted)
    events_.emplace_back(Restarted{peer.session.vehicle(), static_cast<wire::ResetCause>(heard.hail.cause)});
}

void Channel::hearReport(std::size_t index, const wire::Report& report, std::size_t frameBytes) {
  Peer& peer = peers_[index];
  const VehicleId vehicle = peer.session.vehicle();
  came(index, report.ack);
  const auto departure = std::find_if(departures_.begin(), departures_.end(), [&](const Departure& d) {
    return d.bytes > 0 && static_cast<std::uint16_t>(d.counter) == report.ack;
  });
  timing_.answered();
  if (departure != departures_.end() && report.hold < kMaxHold) {
    const Seconds trip = lastByte_ - departure->at - Seconds{report.hold / 1000.0};
    timing_.measured(departure->bytes, frameBytes, trip);
    peer.quality.answered(std::max(trip, Seconds{}));
  } else {
    peer.quality.answered(peer.quality.roundTrip);
  }
  if (peer.silent) events_.emplace_back(BackAgain{vehicle});
  peer.silent = false;
  peer.callsMade = 0;
  peer.quietSince = lastByte_;
  peer.quality.lastHeard = lastByte_;
  if (const auto command = peer.commands.acknowledge(report.ack)) {
    if (command->mode == peer.wish.mode) peer.urgent = false;
    events_.emplace_back(CommandAcknowledged{vehicle, command->counter});
  }
  const Seconds sampledAt = lastByte_ - timing_.oneWay(frameBytes);
  TagStream::Taken taken = peer.tags.take(report, sampledAt);
  peer.quality.tagEventsLost += taken.lost;
  events_.emplace_back(Reported{vehicle, report, lastByte_, sampledAt, timing_.oneWayDoubt(frameBytes),
                                std::move(taken.fresh), taken.lost});
}

void Channel::hearValue(std::size_t index, const wire::Value& value) {
  peers_[index].quietSince = lastByte_;
  const bool expected = flight_ && flight_->kind == Turn::Kind::Request && !requests_.empty() &&
                        requests_.front().peer == index && value.parameter == requests_.front().request.parameter &&
                        value.ack == static_cast<std::uint16_t>(flight_->counter);
  if (!expected) return;  // a late answer to a request that was repeated or given up
  came(index, value.ack);
  events_.emplace_back(Answered{peers_[index].session.vehicle(), requests_.front().request, value});
  requests_.pop_front();
}

void Channel::disbelieve(std::size_t index, Disbelief why) {
  Peer& peer = peers_[index];
  const VehicleId vehicle = peer.session.vehicle();
  switch (why) {
    case Disbelief::WrongKey:
      cameUnlessCalled(index);
      events_.emplace_back(WrongKey{vehicle});
      return;
    case Disbelief::Stale:
      return;
    case Disbelief::Forged:
      ++peer.quality.forged;
      break;
    case Disbelief::Replayed:
      ++peer.quality.replayed;
      break;
    case Disbelief::Strange:
      break;
  }
  events_.emplace_back(Disbelieved{vehicle, why});
}

void Channel::tellNoise() {
  const wire::FrameDecoder::Counters& now = decoder_.counters();
  const Noise noise{now.badCrc - told_.badCrc, now.skipped - told_.skipped, foreign_};
  if (noise.damaged == 0 && noise.skipped == 0 && noise.foreign == 0) return;
  told_ = now;
  foreign_ = 0;
  events_.emplace_back(noise);
}

}  // namespace tessera::link
