// Angles in single precision: the Cortex-M3 has no floating-point unit, and the 100 Hz work does without doubles.
// Bearings are clockwise from north, in radians; the wire's unit is 1/65536 turn.
#pragma once

#include <cmath>
#include <cstdint>

namespace tessera::firmware {

inline constexpr float kPi = 3.14159265F;
inline constexpr float kTurn = 2.0F * kPi;

/// The same angle in [-pi, pi], for angles of up to a few turns.
[[nodiscard]] inline float wrapAngle(float a) {
  while (a > kPi) a -= kTurn;
  while (a < -kPi) a += kTurn;
  return a;
}

/// From and to the wire's 1/65536 turn; negative numbers count backwards.
[[nodiscard]] constexpr float fromBinaryAngle(std::int32_t b) { return static_cast<float>(b) * (kTurn / 65536.0F); }
[[nodiscard]] inline std::uint16_t toBinaryAngle(float a) {
  return static_cast<std::uint16_t>(static_cast<std::int32_t>(std::lround(wrapAngle(a) * (65536.0F / kTurn))));
}

}  // namespace tessera::firmware
