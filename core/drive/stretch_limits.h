// The highest speeds that stretches of a way have of their own, its legs', those of slow zones on it or of its
// bends, by the distance
// from the way's start.
#pragma once

#include <vector>

#include "base/rounded_line.h"
#include "drive/speed_plan.h"

namespace tessera::drive {

struct SpeedStretch {
  Metres from;
  Metres to;
  MetresPerSecond speed;
};

class StretchLimits {
public:
  enum class Of { Legs, Zones, Bends };

  StretchLimits() = default;
  /// In any order; where several lie upon one another, the lowest speed holds.
  StretchLimits(Of of, std::vector<SpeedStretch> stretches);
  [[nodiscard]] static StretchLimits ofLegs(const floor::Route& route) { return ofLegs(route, {}); }
  /// By the distance from the start of `way`, the route with its corners rounded; half of an arc is each leg's.
  [[nodiscard]] static StretchLimits ofLegs(const floor::Route& route, const RoundedLine& way);

  /// What the stretches allow at a distance, where the place is known to within `doubt`: the limit of every one on
  /// which the vehicle may be, and so much before a slower one that it has slowed down where that begins. `from`:
  /// stretches that end before this distance are not driven at all. `delay` is what a command holds on for at least.
  [[nodiscard]] SpeedLimit at(Metres along, Metres doubt, Seconds delay, const SpeedPlan& plan, Metres from = {}) const;
  /// In their order, without overlaps.
  [[nodiscard]] const std::vector<SpeedStretch>& stretches() const { return stretches_; }

private:
  std::vector<SpeedStretch> stretches_;
  SpeedReason here_ = SpeedReason::Leg;
  SpeedReason before_ = SpeedReason::SlowerLeg;
};

}  // namespace tessera::drive
