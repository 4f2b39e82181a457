// Whether a locator's claimed doubt is honest: the normalised squared error of the place (NEES) is 2 on average when it
// is (Bar-Shalom, Li, Kirubarajan, "Estimation with Applications to Tracking and Navigation", 5.4.2).
#pragma once

#include <optional>
#include <vector>

#include "app/experiment/samples.h"

namespace tessera::experiment {

struct Consistency {
  double neesMean = 0.0;
  /// So many independent samples the run's correlated ones are worth, by the sum of their autocorrelations.
  double independent = 0.0;
  double low = 0.0;  ///< within these the mean lies in 95 of 100 runs of an honest locator
  double high = 0.0;
  [[nodiscard]] bool holds() const { return independent > 0.0 && neesMean >= low && neesMean <= high; }
};

/// Of the place claimed at one tick; nullopt where the claim is no covariance.
[[nodiscard]] std::optional<double> neesOf(const Sample& sample);
/// Over a run's ticks in their order.
[[nodiscard]] Consistency consistencyOf(const std::vector<double>& nees);

}  // namespace tessera::experiment
