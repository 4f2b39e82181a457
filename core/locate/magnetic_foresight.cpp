#include "locate/magnetic_foresight.h"

#include <algorithm>
#include <cmath>

namespace tessera::locate {
namespace {

constexpr double kErrorLength = 0.5;  // m, over which the map's own error is another
constexpr Metres kElsewhere{0.2};     // a place that far from the last one was not driven to

}  // namespace

MagneticForesight::Step MagneticForesight::over(const MagneticOutlook& outlook, Point place, double way, double seconds,
                                                double unknown) {
  const MagneticValue value = outlook.map->at(place);
  const bool elsewhere = !followed_ || !(distance(place, last_) < kElsewhere);
  last_ = place;
  const double before = elsewhere ? value.deviation : *followed_;
  const double keep = std::exp(-std::max(0.0, seconds) / kCompassMemory);
  followed_ = keep * before + (1.0 - keep) * value.deviation;
  // About what is expected the error wanders so that it never strays farther than the map and the vehicle's own part
  // are off themselves (an Ornstein-Uhlenbeck process of their variance), and nowhere faster than without a map.
  const double variance = value.variance + outlook.own.variance;
  const double squared = std::min(unknown * unknown, 2.0 * variance / kErrorLength);
  return {*followed_ - before, std::sqrt(squared), 1.0 - std::exp(-0.5 * squared * way / variance),
          *followed_ + outlook.own.mean};
}

}  // namespace tessera::locate
