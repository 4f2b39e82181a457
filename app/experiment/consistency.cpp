#include "app/experiment/consistency.h"

#include <algorithm>
#include <cmath>

namespace tessera::experiment {
namespace {

constexpr double kDimensions = 2.0;
constexpr double kNormal975 = 1.959964;
// Covariances about a run's own mean are too small by that mean's variance, which is the variance by length / n: it is
// added back, once, by the length found without: over and over it would run away in some runs. The sum ends with the
// first that is not positive (Geyer, "Practical Markov chain Monte Carlo", Statistical Science 7(4), 1992).
constexpr int kRounds = 2;
constexpr double kMostShare = 0.5;  // of the run that may be correlated

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
  std::vector<double> products;
  const auto product = [&](std::size_t lag) {
    while (products.size() <= lag) {
      const std::size_t next = products.size();
      double sum = 0.0;
      for (std::size_t i = 0; i + next < n; ++i) sum += (nees[i] - c.neesMean) * (nees[i + next] - c.neesMean);
      products.push_back(sum / static_cast<double>(n - next));
    }
    return products[lag];
  };
  double length = 1.0;
  for (int round = 0; round < kRounds; ++round) {
    const double share = round == 0 ? 0.0 : std::min(kMostShare, length / static_cast<double>(n));
    const double missing = product(0) * share / (1.0 - share);
    const double variance = product(0) + missing;
    length = 1.0;
    for (std::size_t lag = 1; variance > 0.0 && lag < n / 2 && product(lag) + missing > 0.0; ++lag)
      length += 2.0 * (product(lag) + missing) / variance;
  }
  c.independent = std::max(1.0, static_cast<double>(n) / length);
  const double degrees = kDimensions * c.independent;
  c.low = chiSquared(degrees, -kNormal975) / c.independent;
  c.high = chiSquared(degrees, kNormal975) / c.independent;
  return c;
}

}  // namespace tessera::experiment
