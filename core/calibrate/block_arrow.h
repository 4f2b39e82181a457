// Normal equations of a chain of states that hangs on a few shared unknowns: each state meets its successor and the
// shared ones alone, so they are eliminated one after the other, in time that grows with the chain's length and no
// faster (block Gauss elimination; the Schur complement of the shared unknowns is their information).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace tessera::calibrate {

class BlockArrow {
public:
  using State = Eigen::Vector3d;
  using StateSlope = Eigen::Matrix<double, 2, 3>;
  using SharedSlope = Eigen::Matrix<double, 2, Eigen::Dynamic>;

  BlockArrow(std::size_t states, Eigen::Index shared);

  /// A pair of residuals, already divided by their deviations, and its slopes.
  void add(std::size_t state, const StateSlope& slope, const SharedSlope& shared, const Eigen::Vector2d& residual);
  /// The same between a state and its successor.
  void addLink(std::size_t state, const StateSlope& slope, const StateSlope& next, const SharedSlope& shared,
               const Eigen::Vector2d& residual);
  /// What is known beforehand of a shared unknown.
  void addPrior(Eigen::Index unknown, double residual, double perDeviation);

  /// The step that makes the sum of squares least. Once.
  void solve();
  [[nodiscard]] const std::vector<State>& states() const { return step_; }
  [[nodiscard]] const Eigen::VectorXd& shared() const { return sharedStep_; }
  [[nodiscard]] const Eigen::MatrixXd& sharedCovariance() const { return covariance_; }
  /// Of the whole matrix.
  [[nodiscard]] double logDeterminant() const { return logDeterminant_; }
  /// Sum of the squared residuals added.
  [[nodiscard]] double squares() const { return squares_; }

private:
  using Coupling = Eigen::Matrix<double, 3, Eigen::Dynamic>;

  std::vector<Eigen::Matrix3d> own_;
  std::vector<Eigen::Matrix3d> next_;  ///< of a state with its successor
  std::vector<Coupling> coupling_;
  std::vector<State> right_;
  Eigen::MatrixXd sharedOwn_;
  Eigen::VectorXd sharedRight_;
  std::vector<State> step_;
  Eigen::VectorXd sharedStep_;
  Eigen::MatrixXd covariance_;
  double logDeterminant_ = 0.0;
  double squares_ = 0.0;
};

}  // namespace tessera::calibrate
