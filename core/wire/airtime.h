// How long a packet of the E32-TTL-100 is on the air, by the LoRa formula (Semtech AN1200.13, SX1278 data
// sheet 4.1.1.7): explicit header, checksum on, coding rate 4/5, preamble of 8 + 4.25 symbols, no low-rate
// optimisation. It gives the module's data sheet figures of 10/28, 21/49 and 144/308 ms for 12/58 bytes at 19.2k, 9.6k
// and 2.4k. Modules in the field take 1 to 3.2 times as long. Freestanding.
#pragma once

#include <cstddef>

namespace tessera::wire {

/// Spreading factor and bandwidth behind one of the module's air rates.
struct LoRaSetting {
  int spreadingFactor;
  double bandwidth;  ///< Hz
};

/// airRate in bit/s: 300, 1200, 2400, 4800, 9600 or 19200; what lies between counts as the next slower one.
[[nodiscard]] constexpr LoRaSetting loRaSetting(double airRate) {
  if (airRate >= 19200) return {7, 500e3};
  if (airRate >= 9600) return {8, 500e3};
  if (airRate >= 4800) return {10, 500e3};
  if (airRate >= 2400) return {11, 500e3};
  if (airRate >= 1200) return {12, 500e3};
  return {12, 125e3};
}

/// Seconds on the air of one packet of `bytes` (1 to 58).
[[nodiscard]] constexpr double loRaAirtime(std::size_t bytes, double airRate) {
  const LoRaSetting s = loRaSetting(airRate);
  const double symbol = static_cast<double>(1UL << static_cast<unsigned>(s.spreadingFactor)) / s.bandwidth;
  const int bits = 8 * static_cast<int>(bytes) - 4 * s.spreadingFactor + 28 + 16;
  const int perBlock = 4 * s.spreadingFactor;
  const int blocks = bits <= 0 ? 0 : (bits + perBlock - 1) / perBlock;
  return (8 + 4.25 + 8 + 5.0 * blocks) * symbol;
}

}  // namespace tessera::wire
