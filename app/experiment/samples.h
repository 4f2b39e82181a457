// What an experiment records: at each tick of the supervisor what it believed and ordered, beside what was true.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "base/pose.h"

namespace tessera::experiment {

/// What the supervisor knew at one tick; times are the run's clock.
struct Belief {
  Seconds at;
  Pose pose;
  bool located = false;
  bool doubted = false;           ///< located, but it says that it may be elsewhere
  std::array<double, 3> doubt{};  ///< variances of x and y and their covariance, m², as the locator claims them
  MetresPerSecond commandSpeed;
  Radians commandHeading;
  bool driving = false;  ///< judged: under orders on the route, i.e. begun and not yet finished, and located at this
                         ///< tick or before: until then there is no estimate to judge
};

/// The vehicle as the world knows it.
struct Truth {
  Seconds at;
  Pose pose;
  MetresPerSecond speed;
};

struct Sample {
  Belief belief;
  Truth truth;  ///< of the same instant
};

/// True poses of one vehicle in the order of time, interpolated in between.
class TruthTrack {
public:
  TruthTrack() = default;
  explicit TruthTrack(std::vector<Truth> poses) : poses_{std::move(poses)} {}
  /// Nullopt before the first and after the last pose.
  [[nodiscard]] std::optional<Truth> at(Seconds when) const;
  [[nodiscard]] const std::vector<Truth>& poses() const { return poses_; }

private:
  std::vector<Truth> poses_;
};

/// Beliefs for which the truth is known, each with it.
[[nodiscard]] std::vector<Sample> pair(const std::vector<Belief>& beliefs, const TruthTrack& truth);

}  // namespace tessera::experiment
