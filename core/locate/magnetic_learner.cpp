#include "locate/magnetic_learner.h"

#include <algorithm>
#include <cmath>

namespace tessera::locate {
namespace {

constexpr double kSurePlace = 0.05;         // m; of one less sure the map would be smeared
constexpr double kJump = 0.10;              // m between a place and the next one, beyond what was driven
constexpr double kLongestGap = 1.5;         // s between two reports
constexpr double kPiece = 0.03;             // m of way for which the field counts as one
constexpr double kNewsEach = 0.05;          // m of way; news of one pass over a tag hang together
constexpr double kBehind = 0.5;             // m, after which nothing new is told of a node
constexpr double kPerRootMetre = 0.02;      // rad/√m of the compass' error that is neither place nor vehicle
constexpr double kPerTurn = 0.02;           // rad per rad: what is left of soft iron, and the wheels' turns
constexpr double kOwnPerRootMetre = 0.001;  // rad/√m
constexpr double kUnlikely = 2.5;           // deviations beyond which news count less
constexpr double kLongestWay = 1.0;         // m between two reports

double variance(const Estimate& e) { return e.covariance(2, 2); }

}  // namespace

void MagneticLearner::interrupt() {
  last_.reset();
  nodes_.clear();
}

void MagneticLearner::restart() {
  interrupt();
  lessons_.clear();
  own_ = {};
}

void MagneticLearner::begin(const Estimate& known) {
  nodes_.clear();
  state_.resize(2);
  state_ << known.headingBias.value(), own_.mean;
  covariance_.setZero(2, 2);
  covariance_(0, 0) = variance(known);
  covariance_(1, 1) = own_.variance;
  way_ = correctedAt_ = information_ = weighted_ = 0.0;
}

void MagneticLearner::take(const Estimate& moved, const Estimate& known, const MagneticMap& map) {
  const bool sure = moved.located && known.located && known.positionSigma() < Metres{kSurePlace} &&
                    variance(moved) > 0.0 && variance(known) > 0.0;
  const bool jumped = distance(moved.pose.position, known.pose.position) > Metres{kJump};
  if (!sure || jumped) return interrupt();
  const bool goesOn = last_ && known.at >= last_->at && known.at - last_->at < Seconds{kLongestGap} &&
                      distance(last_->pose.position, moved.pose.position) < Metres{kLongestWay};
  if (!goesOn) {
    nodes_.clear();
    begin(known);
  } else if (known.at > last_->at) {
    move(*last_, moved, map);
    note(moved, known);
    if (way_ - correctedAt_ >= kNewsEach) correct();
    leaveBehind(way_ - kBehind);
  }
  last_ = known;
}

Eigen::Index MagneticLearner::indexOf(MagneticNode node, const MagneticMap& map) {
  const auto it = std::find_if(nodes_.begin(), nodes_.end(), [&](const Node& n) { return n.node == node; });
  if (it != nodes_.end()) return 2 + std::distance(nodes_.begin(), it);
  const MagneticValue value = map.at(node);
  nodes_.push_back({node, value.deviation, value.variance, way_});
  const Eigen::Index n = state_.size();
  state_.conservativeResize(n + 1);
  covariance_.conservativeResize(n + 1, n + 1);
  state_(n) = value.deviation;
  covariance_.row(n).setZero();
  covariance_.col(n).setZero();
  covariance_(n, n) = value.variance;
  return n;
}

// The vehicle's heading follows its compass slowly, the compass the floor at once.
void MagneticLearner::move(const Estimate& from, const Estimate& to, const MagneticMap& map) {
  const Offset by = to.pose.position - from.pose.position;
  const double way = length(by).value();
  const double pieces = std::ceil(std::max(1.0, way / kPiece));
  const double keep = std::exp(-(to.at - from.at).value() / pieces / kCompassMemory);
  const double turn = wrapped(to.pose.heading - from.pose.heading).value() / pieces;
  for (double i = 0.0; i < pieces; ++i) {
    way_ += way / pieces;
    const auto shares = MagneticMap::sharesAt(from.pose.position + ((i + 0.5) / pieces) * by);
    std::array<Eigen::Index, 4> at{};
    for (std::size_t s = 0; s < shares.size(); ++s) at[s] = indexOf(shares[s].node, map);
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(state_.size());
    row(0) = keep;
    row(1) = 1.0 - keep;
    for (std::size_t s = 0; s < shares.size(); ++s) {
      nodes_[static_cast<std::size_t>(at[s] - 2)].way = way_;
      row(at[s]) += (1.0 - keep) * shares[s].weight;
    }
    const Eigen::RowVectorXd across = row * covariance_;
    const double noise = kPerRootMetre * kPerRootMetre * way / pieces + kPerTurn * kPerTurn * turn * turn;
    const double own = across.dot(row) + noise;
    state_(0) = row.dot(state_);
    covariance_.row(0) = across;
    covariance_.col(0) = across.transpose();
    covariance_(0, 0) = own;
    covariance_(1, 1) += kOwnPerRootMetre * kOwnPerRootMetre * way / pieces;
  }
}

// The measurement that would have led from the one belief to the other (an inverse Kalman filter): whatever model the
// locator moves by, what it believed before is not counted again.
void MagneticLearner::note(const Estimate& moved, const Estimate& known) {
  const double before = 1.0 / variance(moved);
  const double after = 1.0 / variance(known);
  information_ += after - before;
  const double centre = state_(0);
  weighted_ += after * wrapped(known.headingBias - Radians{centre}).value() -
               before * wrapped(moved.headingBias - Radians{centre}).value() + (after - before) * centre;
}

void MagneticLearner::correct() {
  if (!(information_ > 0.0)) return;
  const double off = weighted_ / information_ - state_(0);
  double noise = 1.0 / information_;
  information_ = weighted_ = 0.0;
  correctedAt_ = way_;
  const double deviations = std::abs(off) / std::sqrt(covariance_(0, 0) + noise);
  if (deviations > kUnlikely) noise *= deviations / kUnlikely;
  const Eigen::VectorXd gain = covariance_.col(0) / (covariance_(0, 0) + noise);
  state_ += gain * off;
  covariance_ -= gain * covariance_.row(0);
  covariance_ = 0.5 * (covariance_ + covariance_.transpose()).eval();
  own_ = {state_(1), std::max(covariance_(1, 1), 1e-6)};
}

void MagneticLearner::leaveBehind(double before) {
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    const Node& node = nodes_[i];
    if (node.way >= before) continue;
    const auto index = static_cast<Eigen::Index>(i) + 2;
    const double information = 1.0 / std::max(covariance_(index, index), 1e-9) - 1.0 / node.variance;
    if (information > 1e-3 / node.variance) {
      const double said = (state_(index) / covariance_(index, index) - node.mean / node.variance) / information;
      lessons_.push_back({node.node, said, 1.0 / information});
    }
    drop(index);
    nodes_.erase(nodes_.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void MagneticLearner::drop(Eigen::Index index) {
  const Eigen::Index after = state_.size() - index - 1;
  state_.segment(index, after) = state_.tail(after).eval();
  covariance_.middleRows(index, after) = covariance_.bottomRows(after).eval();
  covariance_.middleCols(index, after) = covariance_.rightCols(after).eval();
  state_.conservativeResize(state_.size() - 1);
  covariance_.conservativeResize(state_.size(), state_.size());
}

bool MagneticLearner::teach(MagneticMap& map) {
  bool taught = false;
  for (const Lesson& lesson : lessons_) taught = map.learn(lesson.node, lesson.deviation, lesson.variance) || taught;
  lessons_.clear();
  return taught;
}

}  // namespace tessera::locate
