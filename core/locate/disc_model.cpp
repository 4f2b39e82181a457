#include "locate/disc_model.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tessera::locate {
namespace {

constexpr int kCells = 25;  // per axis; fine enough for the rim at walking belief widths
constexpr double kBoxSigmas = 4.0;
constexpr double kRimWidths = 6.0;
constexpr double kLeastSigma = 0.001;  // m; nothing is known better than this

double inDisc(const DiscModel& model, double distance) {
  const double z = (distance - model.radius) / model.rim;
  if (z > 30.0) return 0.0;
  return z < -30.0 ? 1.0 : 1.0 / (1.0 + std::exp(z));
}

double silence(const DiscModel& model, const Eigen::Vector2d& fromTag, const SilentAttempts& silent) {
  double chance = 1.0;
  for (std::size_t i = 0; i < silent.count; ++i)
    chance *= 1.0 - model.detection * inDisc(model, (fromTag + silent.offset[i]).norm());
  return model.outlier + (1.0 - model.outlier) * chance;
}

struct Axis {
  double low, step;
  [[nodiscard]] double at(int i) const { return low + (i + 0.5) * step; }
};

Axis axis(double mean, double sigma, double tag, double reach) {
  const double low = std::max(mean - kBoxSigmas * sigma, tag - reach);
  const double high = std::min(mean + kBoxSigmas * sigma, tag + reach);
  return {low, (high - low) / kCells};
}

}  // namespace

DiscUpdate updateByDisc(const DiscModel& model, const PlaneBelief& before, const Eigen::Vector2d& tag,
                        const SilentAttempts& silent) {
  DiscUpdate result{before, 0.0};
  const double determinant = before.covariance.determinant();
  if (!(determinant > 0.0) || !before.mean.allFinite()) return result;
  const double reach = model.radius + kRimWidths * model.rim;
  const Axis x = axis(before.mean.x(), std::sqrt(before.covariance(0, 0)), tag.x(), reach);
  const Axis y = axis(before.mean.y(), std::sqrt(before.covariance(1, 1)), tag.y(), reach);
  if (!(x.step > 0.0 && y.step > 0.0)) return result;

  const Eigen::Matrix2d precision = before.covariance.inverse();
  double inside = 0.0;
  double weight = 0.0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const Eigen::Vector2d place{x.at(i), y.at(j)};
      const Eigen::Vector2d off = place - before.mean;
      const double seen = inDisc(model, (place - tag).norm());
      if (seen <= 0.0) continue;
      const double prior = std::exp(-0.5 * off.dot(precision * off)) * seen;
      const double w = prior * silence(model, place - tag, silent);
      inside += prior;
      weight += w;
      sum += w * off;
      squares += w * off * off.transpose();
    }
  }
  result.evidence = inside * x.step * y.step / (2.0 * std::numbers::pi * std::sqrt(determinant));
  if (!(weight > 1e-280)) {
    result.evidence = 0.0;
    return result;
  }
  const Eigen::Vector2d shift = sum / weight;
  result.belief.mean = before.mean + shift;
  result.belief.covariance = squares / weight - shift * shift.transpose();
  // What lies inside one cell is not resolved; this also keeps the matrix positive definite.
  result.belief.covariance(0, 0) += x.step * x.step / 12.0 + kLeastSigma * kLeastSigma;
  result.belief.covariance(1, 1) += y.step * y.step / 12.0 + kLeastSigma * kLeastSigma;
  return result;
}

}  // namespace tessera::locate
