// What can be read and set on a vehicle over the air; kept in its EEPROM.
#pragma once

#include <cstdint>

namespace tessera::wire {

/// Numbers are fixed for ever: a new parameter gets a new number.
enum class Parameter : std::uint8_t {
  Address = 1,           ///< 1 to 254; in force after a restart
  WheelDiameter = 2,     ///< µm
  TrackWidth = 3,        ///< µm between the driven wheels' contact points
  CountsPerTurn = 4,     ///< encoder counts of a wheel turn, both edges of both channels
  MaxSpeed = 5,          ///< mm/s
  MaxTurnRate = 6,       ///< mrad/s
  StopDistance = 7,      ///< mm before an obstacle
  Declination = 8,       ///< 1/65536 turn, added to the magnetic bearing; positive east
  CompassOffsetX = 9,    ///< nT, hard iron
  CompassOffsetY = 10,   ///< nT
  CompassMatrixXX = 11,  ///< 1/10000, soft iron: corrected = matrix * (measured - offset)
  CompassMatrixXY = 12,
  CompassMatrixYX = 13,
  CompassMatrixYY = 14,
  CompassMounting = 15,  ///< 1/65536 turn, clockwise angle of the compass' x axis from the nose
  ReaderCount = 16,      ///< 1 to 8
  RadioChannel = 17,     ///< 0 to 31; in force after a restart
  RadioAirRate = 18,     ///< 0 .. 5: 0.3, 1.2, 2.4, 4.8, 9.6, 19.2 kbit/s; in force after a restart
  RadioBaud = 19,        ///< 0 .. 7: 1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200; in force after a restart
  BatteryLow = 20,       ///< mV
  Acceleration = 21,     ///< mm/s^2
  CompassRatio = 22,     ///< 1/10000, share of the compass in the heading per compass sample
  HeadingLearning = 23,  ///< mm of way along which the vehicle learns how unequal its tyres are; 0: it does not
  // Read only:
  FramesRefused = 64,       ///< frames with a wrong MAC or an old counter since the start
  FramesDamaged = 65,       ///< frames with a wrong checksum since the start
  LongestTick = 66,         ///< µs, longest run of the 100 Hz work since the start
  StackFree = 67,           ///< bytes of stack never touched since the start
  CalibrationOutcome = 68,  ///< wire::Outcome of the last compass calibration; Unknown: none since the start
  CompassSample = 128,      ///< the first of kCompassSamples: the field in one direction of the last turn (below)
};

/// Directions of a turn whose fields can be read, as parameters CompassSample and those after it.
inline constexpr std::uint8_t kCompassSamples = 64;

/// The chip's field as it is, before any correction; 25 nT each, 819 µT at most.
struct CompassCounts {
  std::int16_t x = 0;
  std::int16_t y = 0;
  bool operator==(const CompassCounts&) const = default;
};
inline constexpr std::int32_t kCompassCountNanotesla = 25;
/// x in the low half of the value, y in the high half; both -32768: nothing was measured in this direction.
[[nodiscard]] constexpr std::int32_t packCompass(CompassCounts c) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint16_t>(c.y)) << 16 |
                                   static_cast<std::uint16_t>(c.x));
}
[[nodiscard]] constexpr CompassCounts unpackCompass(std::int32_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  return {static_cast<std::int16_t>(bits & 0xFFFF), static_cast<std::int16_t>(bits >> 16)};
}
inline constexpr std::int32_t kNoCompassSample = packCompass({-32768, -32768});

enum class Action : std::uint8_t {
  CalibrateCompass = 1,  ///< turn on the spot, fit hard and soft iron, keep the result
  Restart = 2,
  RestoreDefaults = 3,  ///< everything but address and key
  SurveyCompass = 4,    ///< turn on the spot as to calibrate, and only keep what was measured to be read
};

}  // namespace tessera::wire
