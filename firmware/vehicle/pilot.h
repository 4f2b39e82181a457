// The 100 Hz work: senses, decides what the vehicle does now, and drives the wheels.
#pragma once

#include <optional>

#include "firmware/vehicle/bend.h"
#include "firmware/vehicle/board.h"
#include "firmware/vehicle/command.h"
#include "firmware/vehicle/compass.h"
#include "firmware/vehicle/compass_calibration.h"
#include "firmware/vehicle/drive_control.h"
#include "firmware/vehicle/heading.h"
#include "firmware/vehicle/odometry.h"
#include "firmware/vehicle/rangers.h"
#include "firmware/vehicle/wheel_loop.h"

namespace tessera::firmware {

class Pilot {
public:
  explicit Pilot(Board& board) : board_{board}, compass_{board}, rangers_{board} {}

  void configure(const Settings& settings);
  /// A latched fault that stood before the first tick (kFaultWatchdog).
  void latch(std::uint16_t fault) { latched_ |= fault; }
  /// Stand whatever is commanded, as a vehicle must whose settings are unknown.
  void forbid(bool forbidden) { forbidden_ = forbidden; }

  /// A genuine command that came at `now`. Stop, Drive and Clear end a calibration; Clear forgets latched faults.
  void take(const wire::CycleEntry& entry, Micros now);
  void tick(Micros now);

  /// Started; Busy while driving or calibrating; Failed with a latched fault or without a compass. The calibration ends
  /// by itself when the host has not been heard for two seconds: Polls keep it going. keep: what is found comes into
  /// force; otherwise it is a survey, of which only the samples are wanted.
  wire::Outcome calibrate(Micros now, bool keep);
  /// Outcome of the last calibration: Unknown (none since the start), Started (running), Done or Failed.
  [[nodiscard]] wire::Outcome calibrationOutcome() const;
  /// The field in a direction of the last turn, kNoCompassSample for none.
  [[nodiscard]] std::int32_t compassSample(std::size_t direction) const;
  /// The correction of a calibration that has just succeeded; given once.
  std::optional<CompassCorrection> takeCalibration();

  [[nodiscard]] wire::VehicleState state() const { return state_; }
  /// Faults of motors, encoders, compass and rangers, and what was latched.
  [[nodiscard]] std::uint16_t faults() const;
  [[nodiscard]] float speed() const { return 0.5F * (left_.speed() + right_.speed()); }  ///< m/s
  [[nodiscard]] std::uint16_t travel() const { return odometry_.travel(); }
  [[nodiscard]] float bearing() const { return heading_.bearing(); }
  [[nodiscard]] std::uint8_t rangeCm() const { return rangers_.nearestCm(); }
  /// Grows with each compass sample; its last bits are chance.
  [[nodiscard]] std::uint32_t noise() const { return noise_; }

private:
  void sense(Micros now);
  void feel(const Compass::Sample& sample);
  void watch();
  void decide(Micros now);
  void decideCalibration(Micros now);
  void obey();
  void move(const Motion& motion);
  void brake();

  Board& board_;
  Command command_;
  WheelLoop left_;
  WheelLoop right_;
  Odometry odometry_;
  Compass compass_;
  Heading heading_;
  Bend bend_;
  float wayFelt_ = 0.0F;  ///< m since the last compass sample
  Rangers rangers_;
  DriveControl control_;
  CompassCalibration calibration_;
  bool calibrationTaken_ = true;
  wire::VehicleState state_ = wire::VehicleState::Standing;
  std::uint16_t latched_ = 0;
  bool forbidden_ = false;
  float halfTrack_ = 0.15F;
  int standingTicks_ = 0;
  std::uint32_t noise_ = 0;
};

}  // namespace tessera::firmware
