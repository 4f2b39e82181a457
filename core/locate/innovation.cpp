#include "locate/innovation.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace tessera::locate {
namespace {

constexpr double kInnovationStanding = 0.01;   // m/s
constexpr double kInnovationSwing = 0.05;      // m/s of the reader by turning: less is the compass' noise
constexpr double kInnovationStraight = 0.5;    // of the speed: a reader that swings faster meets tags from anywhere
constexpr double kInnovationPollPeriod = 0.1;  // s between a reader's attempts, as they usually are
constexpr double kInnovationNormal975 = 1.959964;

/// Wilson and Hilferty's approximation of a chi-squared quantile.
double chiSquaredQuantile(double degrees, double normal) {
  const double part = 2.0 / (9.0 * degrees);
  const double root = std::max(0.0, 1.0 - part + normal * std::sqrt(part));
  return degrees * root * root * root;
}

}  // namespace

InDisc inDisc(Metres radius, MetresPerSecond speed, MetresPerSecond swing) {
  const double square = radius.value() * radius.value();
  const double v = speed.value();
  if (std::abs(v) < kInnovationStanding && swing.value() < kInnovationSwing)
    return {Metres{}, 0.25 * square, 0.25 * square};
  // Turning: on the rim, from wherever the tag came.
  if (swing.value() > std::max(kInnovationSwing, kInnovationStraight * std::abs(v)))
    return {Metres{}, 0.5 * square, 0.5 * square};
  // The front rim passes over tags that lie evenly across the way: sqrt(R² - y²) with y even in ±R. By the next attempt
  // the reader has gone on by up to one step.
  const double step = std::min(std::abs(v) * kInnovationPollPeriod, 2.0 * radius.value());
  return {Metres{std::copysign(0.25 * kPi * radius.value() - 0.5 * step, v)},
          square * (2.0 / 3.0 - kPi * kPi / 16.0) + step * step / 12.0, square / 3.0};
}

Innovation innovationOf(const Estimate& before, Offset mount, Metres radius, Point tag) {
  const double theta = before.pose.heading.value();
  const MetresPerSecond swing{std::abs(before.turnRate.value()) * length(mount).value()};
  const InDisc disc = inDisc(radius, before.speed, swing);
  // The reader's place is p + R(heading)·mount.
  const Offset lever = turned(mount, before.pose.heading);
  Eigen::Matrix<double, 2, 3> slope;
  slope << 1.0, 0.0, -lever.y.value(), 0.0, 1.0, lever.x.value();
  Eigen::Matrix2d turn;
  turn << std::cos(theta), -std::sin(theta), std::sin(theta), std::cos(theta);
  const Offset off = tag - (before.pose.position + lever);
  Eigen::Vector2d innovation = turn.transpose() * Eigen::Vector2d{off.x.value(), off.y.value()};
  innovation.x() -= disc.ahead.value();
  Eigen::Matrix2d doubt = turn.transpose() * (slope * before.covariance * slope.transpose()) * turn;
  doubt(0, 0) += disc.along;
  doubt(1, 1) += disc.across;
  Innovation result;
  result.at = before.at;
  result.ahead = Metres{innovation.x()};
  result.aside = Metres{innovation.y()};
  result.nis = innovation.dot(doubt.inverse() * innovation);
  return result;
}

MeanBounds meanBounds(int count) {
  const double n = std::max(1, count);
  return {chiSquaredQuantile(2.0 * n, -kInnovationNormal975) / n,
          chiSquaredQuantile(2.0 * n, kInnovationNormal975) / n};
}

}  // namespace tessera::locate
