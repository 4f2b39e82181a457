// How long things take on this channel: the airtime formula times a factor that is measured while the channel is in
// use (modules take 1 to 3.2 times what their data sheet says), the UARTs at both ends, the module's own pauses.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/units.h"

namespace tessera::link {

class AirTiming {
public:
  /// airRate in bit/s on the air, baud of the UARTs at both ends.
  AirTiming(double airRate, int baud);

  /// From the first byte handed to the sender's module to the last byte out of the receiver's, as measured so far.
  [[nodiscard]] Seconds oneWay(std::size_t bytes) const { return latency(bytes, factor_); }
  /// The same, with room for what the measurements spread; the slowest known module before any measurement.
  [[nodiscard]] Seconds oneWayAtMost(std::size_t bytes) const { return latency(bytes, upperFactor()); }
  /// Length of an answer slot in wire::kSlotUnitMs that keeps two full packets apart; above 255: no room for slots.
  [[nodiscard]] unsigned slotUnits() const;
  /// How many vehicles one Cycle may address, 1 to wire::kMaxCycleEntries.
  [[nodiscard]] std::size_t maxEntries() const;

  /// A frame and its answer have passed. roundTrip: from write to last byte read, less what the vehicle held it.
  void measured(std::size_t sentBytes, std::size_t receivedBytes, Seconds roundTrip);
  /// An answer stayed away though it was waited for, or came. Many misses make the slots longer: answers that collide
  /// cannot be measured. Answers shorten them again, slowly.
  void missed();
  void answered();

  [[nodiscard]] double factor() const { return factor_; }

private:
  [[nodiscard]] Seconds latency(std::size_t bytes, double factor) const;
  [[nodiscard]] double upperFactor() const;

  double airRate_;
  double byteTime_;
  double factor_;
  double deviation_ = 0.0;
  double stretch_ = 1.0;
  double missShare_ = 0.0;
  bool any_ = false;
};

}  // namespace tessera::link
