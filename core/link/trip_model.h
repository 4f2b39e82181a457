// What a round trip consists of: a factor on the airtime of its two frames, and an extra that does not depend on their
// lengths (a slow serial line, a network between host and module, a module that thinks). Frames of different lengths
// tell the two apart; as long as all are alike, only their sum is known, and the factor is given as much of it as it
// can have. Recursive least squares (a Kalman filter of two states), deaf to single outliers.
#pragma once

#include "base/units.h"

namespace tessera::link {

class TripModel {
public:
  /// Modules of the field take 1 to 3.2 times the formula's airtime; nothing beyond these is believed.
  static constexpr double kSmallestFactor = 0.5;
  static constexpr double kLargestFactor = 4.0;
  /// A round trip with more beside the slowest airtime says nothing about the radio: the machine slept. It is passed
  /// over.
  static constexpr Seconds kLongestExtra{5.0};

  /// air: of both frames by the formula, above 0. trip: what of the round trip is neither UART nor the vehicle's own
  /// waiting.
  void measured(Seconds air, Seconds trip);

  [[nodiscard]] bool any() const { return any_; }
  /// Of the formula's airtime, kSmallestFactor to kLargestFactor. Requires any(), as all below.
  [[nodiscard]] double factor() const { return factor_; }
  /// The largest factor that the measurements allow: the whole trip, or two deviations above the estimate.
  [[nodiscard]] double factorAtMost() const;
  /// Standard deviation of factor(); its error is made up for by extra()'s, so that their sum is known much better.
  [[nodiscard]] double factorDoubt() const;
  /// Of a whole round trip, not negative.
  [[nodiscard]] Seconds extra() const { return Seconds{extra_}; }
  /// Mean deviation of the trips from what was expected of them, as in RFC 6298.
  [[nodiscard]] Seconds deviation() const { return Seconds{deviation_}; }
  /// The standard deviation that belongs to it.
  [[nodiscard]] Seconds standardDeviation() const;
  /// By how much the last answers came later than could be expected; 0 when they came in time.
  [[nodiscard]] Seconds late() const { return Seconds{late_}; }
  /// Of both frames by the formula, smoothed.
  [[nodiscard]] Seconds usualAir() const { return Seconds{air_}; }

private:
  void begin(double air, double trip);
  [[nodiscard]] bool isOutlier(double air, double trip, double residual);
  void update(double air, double residual);
  void keepInBounds();

  double factor_ = 0.0;
  double extra_ = 0.0;      // s
  double factorVar_ = 0.0;  // covariance of the two
  double cross_ = 0.0;
  double extraVar_ = 0.0;
  double deviation_ = 0.0;
  double air_ = 0.0;
  double late_ = 0.0;
  int outliers_ = 0;  // in a row, on the same side: their sign is this one's
  bool any_ = false;
};

}  // namespace tessera::link
