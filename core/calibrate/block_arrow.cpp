#include "calibrate/block_arrow.h"

#include <Eigen/LU>
#include <cmath>

namespace tessera::calibrate {

BlockArrow::BlockArrow(std::size_t states, Eigen::Index shared)
    : own_(states, Eigen::Matrix3d::Zero()),
      next_(states, Eigen::Matrix3d::Zero()),
      coupling_(states, Coupling::Zero(3, shared)),
      right_(states, State::Zero()),
      sharedOwn_{Eigen::MatrixXd::Zero(shared, shared)},
      sharedRight_{Eigen::VectorXd::Zero(shared)},
      step_(states, State::Zero()) {}

void BlockArrow::add(std::size_t state, const StateSlope& slope, const SharedSlope& shared,
                     const Eigen::Vector2d& residual) {
  own_[state] += slope.transpose() * slope;
  coupling_[state] += slope.transpose() * shared;
  right_[state] -= slope.transpose() * residual;
  sharedOwn_ += shared.transpose() * shared;
  sharedRight_ -= shared.transpose() * residual;
  squares_ += residual.squaredNorm();
}

void BlockArrow::addLink(std::size_t state, const StateSlope& slope, const StateSlope& next, const SharedSlope& shared,
                         const Eigen::Vector2d& residual) {
  add(state, slope, shared, residual);
  own_[state + 1] += next.transpose() * next;
  next_[state] += slope.transpose() * next;
  coupling_[state + 1] += next.transpose() * shared;
  right_[state + 1] -= next.transpose() * residual;
}

void BlockArrow::addPrior(Eigen::Index unknown, double residual, double perDeviation) {
  sharedOwn_(unknown, unknown) += perDeviation * perDeviation;
  sharedRight_(unknown) -= perDeviation * perDeviation * residual;
  squares_ += perDeviation * perDeviation * residual * residual;
}

void BlockArrow::solve() {
  std::vector<Eigen::Matrix3d> inverse(own_.size());
  logDeterminant_ = 0.0;
  for (std::size_t i = 0; i < own_.size(); ++i) {
    inverse[i] = own_[i].inverse();
    logDeterminant_ += std::log(own_[i].determinant());
    const Coupling weighed = inverse[i] * coupling_[i];
    const State moved = inverse[i] * right_[i];
    sharedOwn_ -= coupling_[i].transpose() * weighed;
    sharedRight_ -= coupling_[i].transpose() * moved;
    if (i + 1 == own_.size()) break;
    own_[i + 1] -= next_[i].transpose() * inverse[i] * next_[i];
    coupling_[i + 1] -= next_[i].transpose() * weighed;
    right_[i + 1] -= next_[i].transpose() * moved;
  }
  covariance_ = sharedOwn_.inverse();
  logDeterminant_ += std::log(sharedOwn_.determinant());
  sharedStep_ = covariance_ * sharedRight_;
  for (std::size_t i = own_.size(); i-- > 0;) {
    State rest = right_[i] - coupling_[i] * sharedStep_;
    if (i + 1 < own_.size()) rest -= next_[i] * step_[i + 1];
    step_[i] = inverse[i] * rest;
  }
}

}  // namespace tessera::calibrate
