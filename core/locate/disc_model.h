// What one tag event says about the place of a reader, as a correction of a Gaussian belief. A reader sees a tag inside
// a disc with a soft rim. A first read says more than "inside": the attempts just before were silent, so the tag has
// just come over the front rim; a last read likewise says that it is about to leave. The exact posterior over the plane
// is taken on a grid and matched by its mean and covariance (assumed-density filtering), so no linearisation of the
// circle is needed.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace tessera::locate {

struct DiscModel {
  double radius = 0.06;      ///< m
  double rim = 0.003;        ///< m, logistic width of the disc's edge
  double detection = 0.88;   ///< chance that an attempt inside the disc succeeds; a little below the truth is safe
  double outlier = 0.01;     ///< chance that the silence around a read says nothing (restart, lost event)
  double pollPeriod = 0.10;  ///< s between a reader's attempts
};

/// Belief about the reader's place at the instant of a read, or the belief after it.
struct PlaneBelief {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();
};

/// Where the reader was, relative to its place at the read, at attempts that saw nothing.
struct SilentAttempts {
  static constexpr std::size_t kMost = 3;
  std::array<Eigen::Vector2d, kMost> offset{};
  std::size_t count = 0;
};

struct DiscUpdate {
  PlaneBelief belief;
  double evidence = 0.0;  ///< chance, under the belief before, that the tag lies in the disc; 0: belief is unchanged
};

[[nodiscard]] DiscUpdate updateByDisc(const DiscModel& model, const PlaneBelief& before, const Eigen::Vector2d& tag,
                                      const SilentAttempts& silent);

}  // namespace tessera::locate
