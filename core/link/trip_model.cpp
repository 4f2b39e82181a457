#include "link/trip_model.h"

#include <algorithm>
#include <cmath>

namespace tessera::link {
namespace {

constexpr double kUsualFactor = 1.8;       // geometric mean of what was seen in the field
constexpr double kFactorDoubt = 0.7;       // standard deviation before lengths have differed
constexpr double kFactorKnown = 0.25;      // standard deviation below which a jump of the trip is the extra's
constexpr double kFirstDeviation = 0.04;   // of the airtime
constexpr double kSmallestNoise = 0.0005;  // s; a vehicle tells its waiting in whole ms
constexpr double kSmallestLimit = 0.010;   // s; what is less is no outlier
constexpr double kOutlier = 5.0;           // mean deviations, i.e. four standard deviations
constexpr double kStandard = 1.25;         // deviations in a mean deviation
constexpr int kJump = 3;                   // outliers in a row are no outliers
constexpr double kDeviationGain = 1.0 / 4;
constexpr double kAirGain = 1.0 / 8;
constexpr double kExtraWander = 0.1;  // standard deviations of the noise, from one trip to the next
constexpr double kFactorWander = 0.002;

double square(double v) { return v * v; }

}  // namespace

double TripModel::factorDoubt() const { return std::sqrt(factorVar_); }

Seconds TripModel::standardDeviation() const { return Seconds{kStandard * deviation_}; }

double TripModel::factorAtMost() const {
  const double whole = factor_ + extra_ / air_;
  return std::clamp(factor_ + 2.0 * factorDoubt(), factor_, std::max(factor_, std::min(whole, kLargestFactor)));
}

void TripModel::measured(Seconds air, Seconds trip) {
  const double a = air.value();
  const double t = trip.value();
  if (!(a > 0.0) || !(t > 0.0) || t > kLargestFactor * a + kLongestExtra.value()) return;
  if (!any_) {
    begin(a, t);
    return;
  }
  const double residual = t - factor_ * a - extra_;
  if (isOutlier(a, t, residual)) return;
  air_ += kAirGain * (a - air_);
  deviation_ += kDeviationGain * (std::abs(residual) - deviation_);
  update(a, residual);
}

// The sum is known, the split is not: with that, the next trip with other lengths moves along the line of equal sums.
void TripModel::begin(double air, double trip) {
  any_ = true;
  air_ = air;
  factor_ = trip / air;
  if (factor_ > kLargestFactor) factor_ = kUsualFactor;
  factor_ = std::max(factor_, kSmallestFactor);
  extra_ = std::max(0.0, trip - factor_ * air);
  deviation_ = kFirstDeviation * air;
  factorVar_ = square(kFactorDoubt);
  cross_ = -air * factorVar_;
  extraVar_ = square(air) * factorVar_ + square(deviation_);
  outliers_ = 0;
  late_ = 0.0;
}

// One answer that a busy machine has held tells nothing; three in a row tell that the way has become another one.
bool TripModel::isOutlier(double air, double trip, double residual) {
  const double split = factorVar_ * square(air) + 2.0 * air * cross_ + extraVar_;
  const double limit = std::max({kOutlier * deviation_, 4.0 * std::sqrt(std::max(0.0, split)), kSmallestLimit});
  if (std::abs(residual) <= limit) {
    outliers_ = 0;
    late_ *= 0.5;
    return false;
  }
  const int side = residual > 0.0 ? 1 : -1;
  outliers_ = outliers_ * side > 0 ? outliers_ + side : side;
  late_ = std::max(0.0, residual);
  deviation_ += kDeviationGain * (limit - deviation_);
  if (std::abs(outliers_) < kJump) return true;
  const double rest = trip - factor_ * air;
  if (factorVar_ > square(kFactorKnown) || rest < 0.0) {
    begin(air, trip);
    return true;
  }
  extra_ = rest;
  deviation_ = kFirstDeviation * air;
  extraVar_ += square(deviation_);
  outliers_ = 0;
  late_ = 0.0;
  return true;
}

void TripModel::update(double air, double residual) {
  const double noise = square(std::max(standardDeviation().value(), kSmallestNoise));
  extraVar_ += square(kExtraWander) * noise;
  factorVar_ += square(kFactorWander);
  const double toFactor = factorVar_ * air + cross_;
  const double toExtra = cross_ * air + extraVar_;
  const double total = toFactor * air + toExtra + noise;
  factor_ += toFactor / total * residual;
  extra_ += toExtra / total * residual;
  factorVar_ -= toFactor * toFactor / total;
  cross_ -= toFactor * toExtra / total;
  extraVar_ -= toExtra * toExtra / total;
  keepInBounds();
}

// What one of the two cannot have is the other's, by as much as they belong together.
void TripModel::keepInBounds() {
  const double allowed = std::clamp(factor_, kSmallestFactor, kLargestFactor);
  if (allowed != factor_) extra_ += cross_ / factorVar_ * (allowed - factor_);
  factor_ = allowed;
  if (extra_ < 0.0) {
    factor_ = std::clamp(factor_ - cross_ / extraVar_ * extra_, kSmallestFactor, kLargestFactor);
    extra_ = 0.0;
  }
  // While all lengths are alike the doubt of the split would grow without end.
  if (factorVar_ > square(kFactorDoubt)) {
    const double scale = kFactorDoubt / std::sqrt(factorVar_);
    factorVar_ *= scale * scale;
    cross_ *= scale;
  }
}

}  // namespace tessera::link
