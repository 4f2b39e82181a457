#include "app/experiment/consistency.h"

#include <algorithm>
#include <cmath>

namespace tessera::experiment {
namespace {

constexpr double kDimensions = 2.0;
constexpr double kNormal975 = 1.959964;
constexpr double kLeastCorrelation = 0.05;  // what lies below is taken for none

/// Wilson and Hilferty's approximation of a chi-squared quantile; within 1 % from two degrees of freedom on for the
/// upper, and good enough for the lower end of the few runs that are so short.
double chiSquared(double degrees, double normal) {
  const double part = 2.0 / (9.0 * degrees);
  const double root = std::max(0.0, 1.0 - part + normal * std::sqrt(part));
  return degrees * root * root * root;
}

}  // namespace

std::optional<double> neesOf(const Sample& sample) {
  const auto [xx, yy, xy] = sample.belief.doubt;
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 0.0) || !(xx > 0.0)) return std::nullopt;
  const Offset off = sample.belief.pose.position - sample.truth.pose.position;
  const double x = off.x.value();
  const double y = off.y.value();
  return (yy * x * x - 2.0 * xy * x * y + xx * y * y) / determinant;
}

Consistency consistencyOf(const std::vector<double>& nees) {
  Consistency c;
  const std::size_t n = nees.size();
  if (n < 2) return c;
  for (const double e : nees) c.neesMean += e / static_cast<double>(n);
  const auto product = [&](std::size_t lag) {
    double sum = 0.0;
    for (std::size_t i = 0; i + lag < n; ++i) sum += (nees[i] - c.neesMean) * (nees[i + lag] - c.neesMean);
    return sum / static_cast<double>(n);
  };
  const double variance = product(0);
  double length = 1.0;
  for (std::size_t lag = 1; variance > 0.0 && lag < n / 2; ++lag) {
    const double correlation = product(lag) / variance;
    if (correlation < kLeastCorrelation) break;
    length += 2.0 * correlation;
  }
  c.independent = std::max(1.0, static_cast<double>(n) / length);
  const double degrees = kDimensions * c.independent;
  c.low = chiSquared(degrees, -kNormal975) / c.independent;
  c.high = chiSquared(degrees, kNormal975) / c.independent;
  return c;
}

}  // namespace tessera::experiment
