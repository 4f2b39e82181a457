// The vehicle's own motion over the last seconds, asked at any instant: between samples by interpolation, of the way by
// the speeds that were told with it; after the last by its speed and turn rate.
#pragma once

#include <cstddef>
#include <vector>

#include "locate/observation.h"

namespace tessera::locate {

class Odometry {
public:
  struct Sample {
    double at = 0.0;        ///< s
    double travel = 0.0;    ///< m, continuous: jumps that no vehicle can make are taken out
    double heading = 0.0;   ///< rad, unwrapped
    double speed = 0.0;     ///< m/s
    double turnRate = 0.0;  ///< rad/s, over the interval that ends at this sample, or that it lies in ...
    double turn = 0.0;      ///< ... and rad, by which it turned in the whole of that interval
  };

  /// fastest: a travel that would need more speed than this is a restarted odometer, not a movement.
  explicit Odometry(MetresPerSecond fastest) : fastest_{fastest.value()} {}

  /// Puts the sample where its instant belongs. False when it is older than the history or holds a number that is none.
  bool add(const Motion& motion);
  void clear() { samples_.clear(); }
  [[nodiscard]] bool empty() const { return samples_.empty(); }
  [[nodiscard]] Seconds last() const { return Seconds{empty() ? 0.0 : samples_.back().at}; }
  /// Requires a sample. Before the first sample: the first, standing. After the last: rolled on for Locator::kMaxCoast.
  [[nodiscard]] Sample at(double instant) const;
  /// Newest sample before `instant`, or `instant` itself if there is none.
  [[nodiscard]] double sampleBefore(double instant) const;
  /// Calls step(Sample from, Sample to) for each stretch between two instants that no sample divides. Requires a
  /// sample.
  template <class Step>
  void walk(double from, double to, Step&& step) const {
    Sample a = at(from);
    for (std::size_t i = firstAfter(from); i < samples_.size() && samples_[i].at < to; ++i) {
      step(a, samples_[i]);
      a = samples_[i];
    }
    if (to > a.at) step(a, at(to));
  }

private:
  [[nodiscard]] std::size_t firstAfter(double instant) const;
  void join(std::size_t index);

  double fastest_;
  double jump_ = 0.0;
  std::vector<Sample> samples_;
};

}  // namespace tessera::locate
