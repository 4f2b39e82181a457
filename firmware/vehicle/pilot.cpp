#include "firmware/vehicle/pilot.h"

#include <algorithm>
#include <bit>

namespace tessera::firmware {
namespace {

using wire::Outcome;
using wire::Parameter;
using wire::VehicleState;

constexpr int kBrakingTicks = 30;  // of active braking before the motors are left alone
constexpr Micros kSilenceEndsCalibration = 2s;

}  // namespace

void Pilot::configure(const Settings& settings) {
  const float metresPerCount = static_cast<float>(settings.get(Parameter::WheelDiameter)) * 1e-6F * kPi /
                               static_cast<float>(settings.get(Parameter::CountsPerTurn));
  const float track = static_cast<float>(settings.get(Parameter::TrackWidth)) * 1e-6F;
  left_.configure(metresPerCount);
  right_.configure(metresPerCount);
  odometry_.configure(track);
  halfTrack_ = 0.5F * track;
  compass_.configure(settings);
  heading_.configure(static_cast<float>(settings.get(Parameter::CompassRatio)) * 1e-4F);
  bend_.configure(static_cast<float>(settings.get(Parameter::HeadingLearning)) * 1e-3F, track);
  rangers_.configure(static_cast<float>(settings.get(Parameter::StopDistance)) * 1e-3F);
  control_.configure(settings);
}

void Pilot::take(const wire::CycleEntry& entry, Micros now) {
  command_.take(entry, now);
  if (entry.mode == wire::CommandMode::Poll) return;
  calibration_.abort();
  if (entry.mode == wire::CommandMode::Clear) {
    latched_ = 0;
    left_.forgive();
    right_.forgive();
    if (!forbidden_) state_ = VehicleState::Standing;  // the answer to this very frame says so already
  }
}

void Pilot::tick(Micros now) {
  sense(now);
  watch();
  decide(now);
}

void Pilot::sense(Micros now) {
  left_.measure(board_.counts(Wheel::Left));
  right_.measure(board_.counts(Wheel::Right));
  odometry_.add(left_.step(), right_.step());
  heading_.turn(odometry_.turned() + bend_.perMetre() * odometry_.way());
  wayFelt_ += odometry_.way();
  const auto sample = compass_.tick(now);
  if (sample) {
    noise_ = std::rotl(noise_, 5) ^ std::bit_cast<std::uint32_t>(sample->raw.x) ^
             std::rotl(std::bit_cast<std::uint32_t>(sample->raw.y), 16);
    if (sample->usable && calibration_.status() != CompassCalibration::Status::Turning) feel(*sample);
  }
  calibration_.tick(odometry_.turned(), sample ? std::optional{sample->raw} : std::nullopt, now);
  rangers_.tick(now);
}

// The bend is the tyres': it is learned where they roll, and kept over stops, commands and calibrations.
void Pilot::feel(const Compass::Sample& sample) {
  const float correction = heading_.compass(sample.bearing);
  if (state_ == VehicleState::Driving) bend_.learn(wayFelt_, correction);
  wayFelt_ = 0.0F;
}

void Pilot::watch() {
  if (left_.stalled() || right_.stalled()) latched_ |= wire::kFaultMotorStall;
  if (left_.implausible() || right_.implausible()) latched_ |= wire::kFaultEncoder;
}

void Pilot::decide(Micros now) {
  const Command::Kind kind = command_.at(now);
  if (latched_ != 0 || forbidden_) {
    calibration_.abort();
    state_ = VehicleState::Faulted;
    brake();
  } else if (calibration_.status() == CompassCalibration::Status::Turning) {
    decideCalibration(now);
  } else if (kind == Command::Kind::Drive) {
    obey();
  } else {
    state_ = kind == Command::Kind::Expired ? VehicleState::Expired : VehicleState::Standing;
    move(control_.stop());
  }
}

void Pilot::decideCalibration(Micros now) {
  if (now - command_.lastHeard() > kSilenceEndsCalibration) calibration_.abort();
  state_ = VehicleState::Calibrating;
  move(control_.spin(calibration_.turnRate()));
}

void Pilot::obey() {
  const float speed = command_.speed();
  if (speed > 0.0F && rangers_.obstacle()) {
    state_ = VehicleState::Obstacle;
    move(control_.stop());
    return;
  }
  move(control_.hold(speed, command_.bearing(), heading_.bearing()));
  if (control_.turning())
    state_ = VehicleState::Turning;
  else
    state_ = speed == 0.0F && control_.standing() ? VehicleState::Standing : VehicleState::Driving;
}

// At a stand the loops brake for a moment, then the motors are left alone.
void Pilot::move(const Motion& motion) {
  standingTicks_ = control_.standing() ? std::min(standingTicks_ + 1, kBrakingTicks) : 0;
  if (standingTicks_ >= kBrakingTicks) {
    brake();
    return;
  }
  // The wheels turn against the bend, so that the vehicle turns as is wished.
  const float side = (motion.turnRate - bend_.perMetre() * motion.speed) * halfTrack_;
  const float push = (motion.turnAcceleration - bend_.perMetre() * motion.acceleration) * halfTrack_;
  board_.drive(Wheel::Left, left_.drive(motion.speed - side, motion.acceleration - push));
  board_.drive(Wheel::Right, right_.drive(motion.speed + side, motion.acceleration + push));
}

void Pilot::brake() {
  control_.halt();
  standingTicks_ = kBrakingTicks;
  board_.drive(Wheel::Left, left_.release());
  board_.drive(Wheel::Right, right_.release());
}

Outcome Pilot::calibrate(Micros now, bool keep) {
  if (latched_ != 0 || forbidden_ || compass_.absent()) return Outcome::Failed;
  const bool busy = calibration_.status() == CompassCalibration::Status::Turning || !control_.standing();
  if (busy || command_.at(now) == Command::Kind::Drive) return Outcome::Busy;
  calibration_.start(now);
  calibrationTaken_ = !keep;
  return Outcome::Started;
}

Outcome Pilot::calibrationOutcome() const {
  switch (calibration_.status()) {
    case CompassCalibration::Status::Idle:
      return Outcome::Unknown;
    case CompassCalibration::Status::Turning:
      return Outcome::Started;
    case CompassCalibration::Status::Done:
      return Outcome::Done;
    case CompassCalibration::Status::Failed:
      break;
  }
  return Outcome::Failed;
}

std::int32_t Pilot::compassSample(std::size_t direction) const {
  const auto field = calibration_.sample(direction);
  if (!field) return wire::kNoCompassSample;
  constexpr float kCounts = 1000.0F / static_cast<float>(wire::kCompassCountNanotesla);
  const auto counts = [](float microtesla) {
    return static_cast<std::int16_t>(std::lround(std::clamp(microtesla * kCounts, -32767.0F, 32767.0F)));
  };
  return wire::packCompass({counts(field->x), counts(field->y)});
}

std::optional<CompassCorrection> Pilot::takeCalibration() {
  if (calibrationTaken_ || calibration_.status() != CompassCalibration::Status::Done) return std::nullopt;
  calibrationTaken_ = true;
  heading_.restart();
  return calibration_.correction();
}

std::uint16_t Pilot::faults() const {
  std::uint16_t faults = latched_;
  if (compass_.absent()) faults |= wire::kFaultCompass;
  if (compass_.outOfRange()) faults |= wire::kFaultCompassRange;
  if (rangers_.faulty()) faults |= wire::kFaultRanger;
  return faults;
}

}  // namespace tessera::firmware
