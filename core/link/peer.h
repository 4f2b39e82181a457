// One vehicle as the channel sees it: its session, its tag events, what it shall do, and how well it is heard.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "link/backoff.h"
#include "link/session.h"
#include "link/tag_stream.h"

namespace tessera::link {

/// What a vehicle shall do from its next Cycle on, until something else is wished.
struct Wish {
  wire::CommandMode mode = wire::CommandMode::Poll;
  MetresPerSecond speed;      ///< Drive; negative backwards, sent in mm/s
  std::uint16_t bearing = 0;  ///< Drive; 1/65536 turn clockwise from north, by the vehicle's own compass
  Seconds expiry;             ///< after reception; sent in 20 ms, at most 5.1 s
};

/// How well a vehicle is heard.
struct LinkQuality {
  std::optional<Seconds> lastHeard;  ///< instant of the last good report
  Seconds roundTrip;                 ///< smoothed, the vehicle's own waiting taken out; 0 before the first
  double loss = 0.0;                 ///< share of the last about 16 polls without answer
  std::uint32_t reports = 0;
  std::uint32_t missed = 0;
  std::uint32_t restarts = 0;
  std::uint32_t forged = 0;
  std::uint32_t replayed = 0;
  std::uint32_t tagEventsLost = 0;

  void answered(Seconds trip) {
    roundTrip = reports == 0 ? trip : roundTrip + 0.125 * (trip - roundTrip);
    loss -= loss / 16;
    ++reports;
  }
  void unanswered() {
    loss += (1.0 - loss) / 16;
    ++missed;
  }
};

/// The last commands that left for a vehicle, to recognise which of them a report acknowledges.
class SentCommands {
public:
  void sent(std::uint32_t counter, wire::CommandMode mode) { ring_[at_++ % ring_.size()] = {counter, mode, true}; }
  struct Acknowledged {
    std::uint32_t counter = 0;
    wire::CommandMode mode = wire::CommandMode::Poll;
  };
  /// The command that left under a counter with these low bits; told once.
  std::optional<Acknowledged> acknowledge(std::uint16_t low) {
    for (Entry& e : ring_) {
      if (!e.waiting || static_cast<std::uint16_t>(e.counter) != low) continue;
      e.waiting = false;
      return Acknowledged{e.counter, e.mode};
    }
    return std::nullopt;
  }

private:
  struct Entry {
    std::uint32_t counter = 0;
    wire::CommandMode mode = wire::CommandMode::Poll;
    bool waiting = false;
  };
  std::array<Entry, 8> ring_{};
  std::size_t at_ = 0;
};

/// The last calls to a vehicle, to time their answers even when they come after the call has been repeated. Where
/// they leave every 0.2 s it holds those of 6 s; an answer that is later than 5 s is not believed to tell the way's
/// length.
class SentCalls {
public:
  struct Call {
    std::uint32_t nonce = 0;
    std::size_t bytes = 0;  ///< 0: none, or its answer has come
    Seconds at;
  };
  void sent(const Call& call) { ring_[at_++ % ring_.size()] = call; }
  /// The call with this nonce; told once, as the same answer once more is a recording.
  std::optional<Call> answered(std::uint32_t nonce) {
    for (Call& c : ring_)
      if (c.bytes > 0 && c.nonce == nonce) return std::exchange(c, {});
    return std::nullopt;
  }

private:
  std::array<Call, 32> ring_{};
  std::size_t at_ = 0;
};

struct Peer {
  Peer(VehicleId id, const wire::Key& key, const std::optional<wire::Key>& offered = {}) : session{id, key, offered} {}

  /// It is polled and commanded in the Cycles.
  [[nodiscard]] bool connected() const { return session.open() && !silent; }
  void wishFor(const Wish& w) {
    const bool stand = w.mode == wire::CommandMode::Stop || w.mode == wire::CommandMode::Clear;
    if (w.mode != wish.mode) urgent = stand;
    if (w.mode != wish.mode) urgentTries = 0;
    wish = w;
  }

  Session session;
  TagStream tags;
  Wish wish;
  SentCommands commands;
  SentCalls called;
  LinkQuality quality;
  Backoff calls{Seconds{0.2}, Seconds{2.0}};
  unsigned callsMade = 0;             ///< since it was last heard
  bool silent = false;                ///< a session stands, its answers stay away
  bool urgent = false;                ///< a Stop or Clear that is not acknowledged yet
  unsigned urgentTries = 0;           ///< of this Stop or Clear
  std::optional<Seconds> quietSince;  ///< last sign of life, or start of listening; for silence
  std::optional<Seconds> lastCycle;   ///< when it was last part of a Cycle
};

}  // namespace tessera::link
