#include "firmware/vehicle/compass_calibration.h"

#include <algorithm>

#include "firmware/vehicle/angles.h"

namespace tessera::firmware {
namespace {

constexpr float kRate = 0.8F;           // rad/s: some 1 degree a sample
constexpr float kSweep = kTurn * 1.1F;  // radians each way
constexpr Micros kLongestTurning = 60s;
constexpr std::size_t kFewestBins = 58;  // of 64: gaps of at most a few samples
constexpr float kWorstMisfit = 0.05F;    // of the radius; 3 degrees
constexpr float kWorstAxisRatio = 4.0F;
constexpr std::size_t kSectors = 24;  // of the corrected bearings, each of which must have been met

}  // namespace

void CompassCalibration::start(Micros now) {
  *this = {};
  status_ = Status::Turning;
  started_ = now;
}

void CompassCalibration::abort() {
  if (status_ == Status::Turning) status_ = Status::Failed;
}

float CompassCalibration::turnRate() const {
  if (status_ != Status::Turning) return 0.0F;
  return back_ ? -kRate : kRate;
}

CompassCalibration::Status CompassCalibration::tick(float turned, std::optional<Field> field, Micros now) {
  if (status_ != Status::Turning) return status_;
  angle_ += turned;
  if (field) add(*field);
  if (now - started_ > kLongestTurning) {
    status_ = Status::Failed;
  } else if (!back_) {
    back_ = angle_ >= kSweep;
  } else if (angle_ <= 0.0F) {
    finish();
  }
  return status_;
}

// Averages over 5.6 degrees of turn take most of the noise off and give every direction the same weight.
void CompassCalibration::add(Field field) {
  const float share = (wrapAngle(angle_) + kPi) / kTurn;
  Bin& bin = bins_[std::min(static_cast<std::size_t>(share * static_cast<float>(kBins)), kBins - 1)];
  ++bin.count;
  bin.x += (field.x - bin.x) / static_cast<float>(bin.count);
  bin.y += (field.y - bin.y) / static_cast<float>(bin.count);
}

std::optional<Field> CompassCalibration::sample(std::size_t direction) const {
  if (direction >= kBins || bins_[direction].count == 0) return std::nullopt;
  return Field{bins_[direction].x, bins_[direction].y};
}

void CompassCalibration::finish() {
  status_ = Status::Failed;
  std::array<Field, kBins> samples{};
  std::size_t count = 0;
  for (const Bin& bin : bins_)
    if (bin.count > 0) samples[count++] = {bin.x, bin.y};
  if (count < kFewestBins) return;
  const std::span<const Field> all = std::span{samples}.first(count);
  const auto fit = fitEllipse(all);
  if (!fit || fit->misfit > kWorstMisfit || fit->axisRatio > kWorstAxisRatio || fit->radius < kWeakestField ||
      fit->radius > kStrongestField)
    return;
  std::array<bool, kSectors> met{};
  for (const Field& s : all) {
    const Field c = fit->correction.apply(s);
    const float share = (std::atan2(c.y, c.x) + kPi) / kTurn;
    met[std::min(static_cast<std::size_t>(share * static_cast<float>(kSectors)), kSectors - 1)] = true;
  }
  if (std::count(met.begin(), met.end(), true) < static_cast<std::ptrdiff_t>(kSectors)) return;
  correction_ = fit->correction;
  status_ = Status::Done;
}

}  // namespace tessera::firmware
