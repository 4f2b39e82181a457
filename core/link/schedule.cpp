#include "link/schedule.h"

#include <algorithm>

namespace tessera::link {
namespace {

constexpr unsigned kProbeEvery = 3;  // a vehicle with another key hears no call, but answers a probe with a Hail

bool contains(const Turn& turn, std::size_t peer) {
  const auto end = turn.peers.begin() + static_cast<std::ptrdiff_t>(turn.count);
  return std::find(turn.peers.begin(), end, peer) != end;
}

}  // namespace

Turn Schedule::next(std::span<const Peer> peers, std::size_t maxEntries, bool requestWaiting, Seconds now) {
  if (Turn turn = urgent(peers, maxEntries); turn.kind != Turn::Kind::Nothing) {
    lastCycle_ = now;
    return turn;
  }
  const auto connected =
      static_cast<std::size_t>(std::count_if(peers.begin(), peers.end(), [](const Peer& p) { return p.connected(); }));
  Seconds wake = kNever;
  if (servedSinceAside_ >= connected) {
    const Turn turn = aside(peers, requestWaiting, now);
    if (turn.kind != Turn::Kind::Nothing) {
      servedSinceAside_ = 0;
      return turn;
    }
    wake = turn.wake;
  }
  Turn turn = cycle(peers, maxEntries, now);
  if (turn.kind == Turn::Kind::Nothing) {
    turn.wake = std::min(turn.wake, wake);
    // While Cycles pause, calls need not wait for a round.
    servedSinceAside_ = connected;
  }
  return turn;
}

Turn Schedule::urgent(std::span<const Peer> peers, std::size_t maxEntries) {
  Turn turn;
  bool repeated = false;
  for (std::size_t i = 0; i < peers.size() && turn.count < maxEntries; ++i) {
    if (!peers[i].connected() || !peers[i].urgent) continue;
    turn.peers[turn.count++] = i;
    repeated = repeated || peers[i].urgentTries > 0;
  }
  if (turn.count == 0) return turn;
  turn.kind = Turn::Kind::Cycle;
  // A first stop travels alone: a shorter frame arrives earlier. One that is not heard must not starve the others.
  if (repeated) fill(turn, peers, maxEntries);
  return turn;
}

Turn Schedule::aside(std::span<const Peer> peers, bool requestWaiting, Seconds now) {
  Turn turn;
  turn.wake = kNever;
  callsTurn_ = !callsTurn_ || !requestWaiting;
  if (requestWaiting && !callsTurn_) {
    turn.kind = Turn::Kind::Request;
    return turn;
  }
  for (std::size_t step = 0; step < peers.size(); ++step) {
    const std::size_t i = (callCursor_ + step) % peers.size();
    const Peer& peer = peers[i];
    if (peer.connected()) continue;
    turn.wake = std::min(turn.wake, peer.calls.next());
    if (!peer.calls.due(now)) continue;
    callCursor_ = i + 1;
    turn.kind = peer.callsMade % kProbeEvery == kProbeEvery - 1 ? Turn::Kind::Probe : Turn::Kind::Call;
    turn.peers[0] = i;
    turn.count = 1;
    return turn;
  }
  if (requestWaiting) turn.kind = Turn::Kind::Request;
  return turn;
}

Turn Schedule::cycle(std::span<const Peer> peers, std::size_t maxEntries, Seconds now) {
  Turn turn;
  turn.wake = kNever;
  const bool anyone = std::any_of(peers.begin(), peers.end(), [](const Peer& p) { return p.connected(); });
  if (!anyone) return turn;
  const bool driving = std::any_of(peers.begin(), peers.end(), [](const Peer& p) {
    return p.connected() && p.wish.mode == wire::CommandMode::Drive;
  });
  if (!driving && now < lastCycle_ + idlePeriod_) {
    turn.wake = lastCycle_ + idlePeriod_;
    return turn;
  }
  fill(turn, peers, maxEntries);
  turn.kind = Turn::Kind::Cycle;
  lastCycle_ = now;
  return turn;
}

// Adds connected vehicles in turn, from where the last Cycle ended.
void Schedule::fill(Turn& turn, std::span<const Peer> peers, std::size_t maxEntries) {
  const std::size_t begin = cycleCursor_;
  for (std::size_t step = 0; step < peers.size() && turn.count < maxEntries; ++step) {
    const std::size_t i = (begin + step) % peers.size();
    if (!peers[i].connected() || contains(turn, i)) continue;
    turn.peers[turn.count++] = i;
    ++servedSinceAside_;
    cycleCursor_ = (i + 1) % peers.size();
  }
}

}  // namespace tessera::link
