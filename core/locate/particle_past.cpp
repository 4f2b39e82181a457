// Where a reader stood when it read or was silent: what was driven and turned since.
#include <algorithm>
#include <cmath>

#include "locate/particle_locator.h"

namespace tessera::locate {
namespace {

constexpr double kNoWay = 1e-6;  // m

}  // namespace

ReaderThen ParticleLocator::readerThen(int reader, double at) const {
  const double then = at - options_.readLag;
  const Odometry::Sample sample = odometry_.at(then);
  const Offset mount = turned(vehicle_.readers[static_cast<std::size_t>(reader)], Radians{sample.heading});
  ReaderThen result;
  result.lever = {mount.x.value(), mount.y.value()};
  // How evenly it turned between two reports nobody told.
  result.rim = std::hypot(options_.instant * sample.speed, options_.turnShare * sample.turn * result.lever.norm());
  const double now = odometry_.last().value();
  result.way = wayBetween(then, now);
  if (then < cloudFrom_) {
    result.before = wayBetween(then, cloudFrom_);
    result.back = 1.0;
  } else if (then <= now) {
    const double since = odometry_.at(now).travel - sample.travel;
    const double whole = odometry_.at(now).travel - odometry_.at(cloudFrom_).travel;
    result.back = std::abs(whole) > kNoWay ? std::clamp(since / whole, 0.0, 1.0) : 0.0;
  } else {
    result.before = result.way;
  }
  return result;
}

Eigen::Vector2d ParticleLocator::wayBetween(double from, double to) const {
  Eigen::Vector2d way = Eigen::Vector2d::Zero();
  odometry_.walk(std::min(from, to), std::max(from, to), [&](const Odometry::Sample& a, const Odometry::Sample& b) {
    const double heading = 0.5 * (a.heading + b.heading);
    way += (b.travel - a.travel) * Eigen::Vector2d{std::cos(heading), std::sin(heading)};
  });
  return to < from ? Eigen::Vector2d{-way} : way;
}

}  // namespace tessera::locate
