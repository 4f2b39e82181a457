// The arithmetic of the Kalman locator: place, compass bias and odometer scale of one vehicle. The heading is no state
// of its own: it is the reported one minus the bias, so the compass is never counted twice.
#pragma once

#include <Eigen/Core>

#include "base/pose.h"
#include "locate/disc_model.h"
#include "locate/odometry.h"

namespace tessera::locate {

struct KalmanOptions {
  double startSigma = 0.05;         ///< m, of a start pose
  double biasSigma = 0.07;          ///< rad, of the compass bias at the start
  double biasPerRootMetre = 0.10;   ///< rad/√m: the floor's magnetic field changes from place to place
  double biasPerTurn = 0.02;        ///< rad per rad: what is left of soft iron changes with the heading
  double headingNoise = 0.02;       ///< rad, of one reported heading
  double scaleSigma = 0.06;         ///< share, of the odometer's scale (wheel wear, slip), standing long
  double scaleLength = 0.5;         ///< m, over which the scale is forgotten
  double slipPerRootMetre = 0.005;  ///< m/√m, of the wheels, in each direction
  double turnShare = 0.2;           ///< of a heading change between two samples: doubt about the direction meanwhile
  double gate = 2e-3;               ///< a read less likely than this contradicts the estimate
  double surprise = 0.05;           ///< a read less likely than this is taken in with more doubt about the place
  double surpriseSigma = 0.02;      ///< m, that doubt
  double largestSigma = 0.20;       ///< m: with more doubt about the place it does not count as located
};

class KalmanFilter {
public:
  enum Index { kX, kY, kBias, kScale };
  using Vector = Eigen::Vector4d;
  using Matrix = Eigen::Matrix4d;

  /// At a place known to `sigma`, which makes the filter know where it is. Keeps a bias learned before.
  void place(const KalmanOptions& options, Point where, double sigma);
  void forget(const KalmanOptions& options);
  [[nodiscard]] bool placed() const { return placed_; }

  void predict(const KalmanOptions& options, const Odometry::Sample& from, const Odometry::Sample& to);
  /// Takes in that the reader at `mount` had `tag` in its disc when the vehicle reported `heading`. Returns the chance
  /// of that beforehand; below options.gate nothing changes.
  double correct(const KalmanOptions& options, const DiscModel& model, Offset mount, double heading,
                 const Eigen::Vector2d& tag, const SilentAttempts& silent);

  [[nodiscard]] const Vector& state() const { return state_; }
  [[nodiscard]] const Matrix& covariance() const { return covariance_; }
  /// Of x, y and heading, when one reported heading has the given noise.
  [[nodiscard]] Eigen::Matrix3d poseCovariance(const KalmanOptions& options) const;

private:
  void keepSymmetric();

  Vector state_{0.0, 0.0, 0.0, 1.0};
  Matrix covariance_ = Matrix::Identity();
  bool placed_ = false;
  bool seeded_ = false;
};

}  // namespace tessera::locate
