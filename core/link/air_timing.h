// How long things take on this channel: the airtime formula times a factor and a delay beside it, both measured while
// the channel is in use (modules take 1 to 3.2 times what their data sheet says, and something may lie between them and
// us), the UARTs at both ends, the module's own pauses.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/units.h"
#include "link/trip_model.h"

namespace tessera::link {

class AirTiming {
public:
  /// airRate in bit/s on the air, baud of the UARTs at both ends.
  AirTiming(double airRate, int baud);

  /// From the first byte handed to the sender's module to the last byte out of the receiver's, as measured so far.
  [[nodiscard]] Seconds oneWay(std::size_t bytes) const { return latency(bytes, factor()) + delay(); }
  /// The same, with room for what the measurements spread and leave open, and for answers that have begun to come
  /// later; the slowest known module before any measurement.
  [[nodiscard]] Seconds oneWayAtMost(std::size_t bytes) const;
  /// Standard deviation of oneWay() for a single frame: what trips spread, and that lengths have not told the factor
  /// from the delay yet. How the delay is shared between both ways is not in it. 0 before any measurement.
  [[nodiscard]] Seconds oneWayDoubt(std::size_t bytes) const;
  /// Length of an answer slot in wire::kSlotUnitMs that keeps two full packets apart; above 255: no room for slots.
  [[nodiscard]] unsigned slotUnits() const;
  /// How many vehicles one Cycle may address, 1 to wire::kMaxCycleEntries.
  [[nodiscard]] std::size_t maxEntries() const;

  /// A frame and its answer have passed. roundTrip: from write to last byte read, less what the vehicle held it.
  void measured(std::size_t sentBytes, std::size_t receivedBytes, Seconds roundTrip);
  /// A call and its answer have passed. Until a frame is measured this tells how long to wait, also where the way has
  /// become a longer one since the last frame; how long the vehicle held it is not known, so it tells no more.
  void called(std::size_t sentBytes, std::size_t receivedBytes, Seconds roundTrip);
  /// An answer stayed away though it was waited for, or came. Many misses make the slots longer: answers that collide
  /// cannot be measured. Answers shorten them again, slowly.
  void missed();
  void answered();

  [[nodiscard]] double factor() const;
  /// One way's share of what the round trips hold beside airtime: half. Where the way there takes longer than the way
  /// back, or shorter, no round trip tells, and nothing that a vehicle sends: its clock and its ages know nothing of
  /// ours. Reports are then taken too late, or too early, by half the difference.
  [[nodiscard]] Seconds delay() const;

private:
  [[nodiscard]] Seconds latency(std::size_t bytes, double factor) const;
  [[nodiscard]] double upperFactor() const;
  [[nodiscard]] double unsteady() const;

  double airRate_;
  double byteTime_;
  TripModel trips_;
  double called_ = 0.0;  // s of a call's round trip beyond the slowest module's; 0 once a frame is measured
  double stretch_ = 1.0;
  double missShare_ = 0.0;
};

}  // namespace tessera::link
