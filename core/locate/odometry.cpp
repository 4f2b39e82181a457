#include "locate/odometry.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "locate/locator.h"

namespace tessera::locate {
namespace {

constexpr std::size_t kPruneSamplesAt = 256;
constexpr double kShortest = 1e-6;      // s; closer samples say nothing about a rate
constexpr double kNoWayBetween = 1e-5;  // m
constexpr double kLeastJump = 0.05;     // m; smaller steps may be rounding or a late sample

double fraction(double part, double whole) { return whole > kShortest ? part / whole : 1.0; }

/// Share of the way between two samples after this share of their time, by the speeds at both ends: a cubic that never
/// turns back (Fritsch and Carlson, "Monotone piecewise cubic interpolation", SIAM J. Numer. Anal. 17(2), 1980).
double shareOfWay(double part, double way, double time, double speedBefore, double speedAfter) {
  if (std::abs(way) < kNoWayBetween) return part;
  const double before = std::clamp(speedBefore * time / way, 0.0, 3.0);
  const double after = std::clamp(speedAfter * time / way, 0.0, 3.0);
  return part * (before + part * (3.0 - 2.0 * before - after + part * (before + after - 2.0)));
}

}  // namespace

std::size_t Odometry::firstAfter(double instant) const {
  const auto it = std::upper_bound(samples_.begin(), samples_.end(), instant,
                                   [](double t, const Sample& sample) { return t < sample.at; });
  return static_cast<std::size_t>(std::distance(samples_.begin(), it));
}

void Odometry::join(std::size_t index) {
  if (index == 0 || index >= samples_.size()) return;
  const Sample& before = samples_[index - 1];
  Sample& sample = samples_[index];
  sample.heading = before.heading + wrapped(Radians{sample.heading - before.heading}).value();
  const double time = sample.at - before.at;
  sample.turn = sample.heading - before.heading;
  sample.turnRate = time > kShortest ? sample.turn / time : before.turnRate;
}

bool Odometry::add(const Motion& motion) {
  Sample sample{motion.at.value(), motion.travel.value() + jump_, motion.heading.value(), motion.speed.value(), 0.0};
  if (!std::isfinite(sample.at + sample.travel + sample.heading + sample.speed)) return false;
  if (!empty() && sample.at < samples_.back().at - Locator::kHistory.value()) return false;
  const std::size_t index = firstAfter(sample.at);
  if (index > 0 && index == samples_.size()) {
    const Sample& before = samples_.back();
    const double moved = sample.travel - before.travel;
    if (std::abs(moved) > kLeastJump + 1.5 * fastest_ * (sample.at - before.at)) {
      jump_ -= moved;
      sample.travel = before.travel;
    }
  }
  samples_.insert(samples_.begin() + static_cast<std::ptrdiff_t>(index), sample);
  join(index);
  join(index + 1);
  if (samples_.size() > kPruneSamplesAt) {
    const double oldest = samples_.back().at - Locator::kHistory.value() - 1.0;
    const std::size_t keep = std::max<std::size_t>(firstAfter(oldest), 1) - 1;
    samples_.erase(samples_.begin(), samples_.begin() + static_cast<std::ptrdiff_t>(keep));
  }
  return true;
}

Odometry::Sample Odometry::at(double instant) const {
  const std::size_t next = firstAfter(instant);
  if (next == 0) {
    Sample first = samples_.front();
    first.at = instant;
    first.speed = first.turnRate = 0.0;
    return first;
  }
  Sample sample = samples_[next - 1];
  if (next == samples_.size()) {
    const double coast = std::min(instant - sample.at, Locator::kMaxCoast.value());
    sample.travel += sample.speed * coast;
    sample.heading += sample.turnRate * coast;
  } else {
    const Sample& after = samples_[next];
    const double part = fraction(instant - sample.at, after.at - sample.at);
    const double way = after.travel - sample.travel;
    sample.travel += way * shareOfWay(part, way, after.at - sample.at, sample.speed, after.speed);
    sample.heading += part * (after.heading - sample.heading);
    sample.speed += part * (after.speed - sample.speed);
    sample.turnRate = after.turnRate;
    sample.turn = after.turn;
  }
  sample.at = instant;
  return sample;
}

double Odometry::sampleBefore(double instant) const {
  const std::size_t next = firstAfter(instant);
  return next == 0 ? instant : samples_[next - 1].at;
}

}  // namespace tessera::locate
