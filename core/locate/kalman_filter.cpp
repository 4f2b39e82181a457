#include "locate/kalman_filter.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace tessera::locate {
namespace {

double square(double v) { return v * v; }

constexpr double kSmallestVariance = 1e-12;
constexpr double kRounding = 1e-6;  // m², of places in map and messages

}  // namespace

void KalmanFilter::place(const KalmanOptions& options, Point where, double sigma) {
  if (!seeded_) forget(options);
  state_(kX) = where.x.value();
  state_(kY) = where.y.value();
  covariance_.topRows<2>().setZero();
  covariance_.leftCols<2>().setZero();
  covariance_(kX, kX) = covariance_(kY, kY) = square(sigma);
  // Wherever it was carried, the floor's field there is another.
  covariance_(kBias, kBias) = std::max(covariance_(kBias, kBias), square(options.biasSigma));
  placed_ = true;
}

void KalmanFilter::forget(const KalmanOptions& options) {
  state_ << 0.0, 0.0, 0.0, 1.0;
  covariance_.setZero();
  covariance_.diagonal() << 1.0, 1.0, square(options.biasSigma), square(options.scaleSigma);
  placed_ = false;
  seeded_ = true;
}

void KalmanFilter::predict(const KalmanOptions& options, const Odometry::Sample& from, const Odometry::Sample& to) {
  if (!placed_) return;
  const double turn = to.heading - from.heading;
  const double half = 0.5 * turn;
  // A run of even curvature is driven on an arc; its chord is what moves the place.
  const double chord = (to.travel - from.travel) * (std::abs(half) > 1e-4 ? std::sin(half) / half : 1.0);
  const double way = std::abs(to.travel - from.travel);
  const double heading = from.heading + half - state_(kBias);
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  const double step = chord * state_(kScale);

  Matrix f = Matrix::Identity();
  f(kX, kBias) = step * s;
  f(kX, kScale) = chord * c;
  f(kY, kBias) = -step * c;
  f(kY, kScale) = chord * s;
  const double keep = std::exp(-way / options.scaleLength);
  f(kScale, kScale) = keep;

  state_(kX) += step * c;
  state_(kY) += step * s;
  state_(kScale) = 1.0 + keep * (state_(kScale) - 1.0);
  covariance_ = f * covariance_ * f.transpose();

  const double slip = square(options.slipPerRootMetre) * way;
  const double across = slip + square(step) * (square(options.headingNoise) + square(options.turnShare * turn));
  covariance_(kX, kX) += slip * c * c + across * s * s;
  covariance_(kY, kY) += slip * s * s + across * c * c;
  covariance_(kX, kY) += (slip - across) * c * s;
  covariance_(kY, kX) += (slip - across) * c * s;
  covariance_(kBias, kBias) += square(options.biasPerRootMetre) * way + square(options.biasPerTurn * turn);
  covariance_(kScale, kScale) += square(options.scaleSigma) * (1.0 - square(keep));
  keepSymmetric();
}

double KalmanFilter::correct(const KalmanOptions& options, const DiscModel& model, Offset mount, double heading,
                             const Eigen::Vector2d& tag, const SilentAttempts& silent) {
  const double c = std::cos(heading - state_(kBias));
  const double s = std::sin(heading - state_(kBias));
  const double mx = mount.x.value();
  const double my = mount.y.value();
  const Eigen::Vector2d lever{c * mx - s * my, s * mx + c * my};
  const Eigen::Vector2d byBias{lever.y(), -lever.x()};  // change of the reader's place with the bias

  Eigen::Matrix<double, 2, 4> g = Eigen::Matrix<double, 2, 4>::Zero();
  g(0, kX) = g(1, kY) = 1.0;
  g.col(kBias) = byBias;
  const Eigen::Matrix2d noise =
      square(options.headingNoise) * byBias * byBias.transpose() + kRounding * Eigen::Matrix2d::Identity();
  PlaneBelief before{state_.head<2>() + lever, g * covariance_ * g.transpose() + noise};
  DiscUpdate update = updateByDisc(model, before, tag, silent);
  const double evidence = update.evidence;
  if (!(evidence >= options.gate)) return evidence;
  if (evidence < options.surprise) {
    // Off by more than it believes: a wrong start, a slip. Doubting more, it comes back in a few reads.
    covariance_(kX, kX) += square(options.surpriseSigma);
    covariance_(kY, kY) += square(options.surpriseSigma);
    before.covariance += square(options.surpriseSigma) * Eigen::Matrix2d::Identity();
    update = updateByDisc(model, before, tag, silent);
  }

  const Eigen::Matrix<double, 4, 2> gain = covariance_ * g.transpose() * before.covariance.inverse();
  state_ += gain * (update.belief.mean - before.mean);
  covariance_ += gain * (update.belief.covariance - before.covariance) * gain.transpose();
  keepSymmetric();
  return evidence;
}

Eigen::Matrix3d KalmanFilter::poseCovariance(const KalmanOptions& options) const {
  Eigen::Matrix3d pose = covariance_.topLeftCorner<3, 3>();
  pose.row(2) *= -1.0;
  pose.col(2) *= -1.0;
  pose(2, 2) += square(options.headingNoise);
  return pose;
}

void KalmanFilter::keepSymmetric() {
  const Matrix transposed = covariance_.transpose();
  covariance_ = 0.5 * (covariance_ + transposed);
  covariance_.diagonal() = covariance_.diagonal().cwiseMax(kSmallestVariance);
}

}  // namespace tessera::locate
