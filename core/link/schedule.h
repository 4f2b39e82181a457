// Who has the air next. Stops go before everything; then Cycles, up to four vehicles each and all in turn; and after
// every round of all vehicles at most one call or request, so that those who drive are never kept waiting by those who
// are absent.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include "link/peer.h"

namespace tessera::link {

inline constexpr Seconds kNever{std::numeric_limits<double>::infinity()};

struct Turn {
  enum class Kind {
    Nothing,
    Cycle,    ///< to `peers[0 .. count)`
    Call,     ///< Hello to peers[0]
    Probe,    ///< a Cycle with one polling entry for peers[0], which has no session or is silent
    Request,  ///< the oldest one waiting
  };
  Kind kind = Kind::Nothing;
  std::array<std::size_t, wire::kMaxCycleEntries> peers{};  ///< indices
  std::size_t count = 0;
  Seconds wake;  ///< Nothing: when to ask again
};

class Schedule {
public:
  /// idlePeriod: pause between Cycles while no vehicle shall drive.
  explicit Schedule(Seconds idlePeriod) : idlePeriod_{idlePeriod} {}
  /// maxEntries: 1 to wire::kMaxCycleEntries. requestWaiting: for a connected vehicle.
  [[nodiscard]] Turn next(std::span<const Peer> peers, std::size_t maxEntries, bool requestWaiting, Seconds now);

private:
  [[nodiscard]] Turn urgent(std::span<const Peer> peers, std::size_t maxEntries);
  [[nodiscard]] Turn aside(std::span<const Peer> peers, bool requestWaiting, Seconds now);
  [[nodiscard]] Turn cycle(std::span<const Peer> peers, std::size_t maxEntries, Seconds now);
  void fill(Turn& turn, std::span<const Peer> peers, std::size_t maxEntries);

  Seconds idlePeriod_;
  Seconds lastCycle_{-1e9};
  std::size_t cycleCursor_ = 0;
  std::size_t callCursor_ = 0;
  std::size_t servedSinceAside_ = 0;
  bool callsTurn_ = true;
};

}  // namespace tessera::link
