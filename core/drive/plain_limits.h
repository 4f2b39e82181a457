// What binds whoever leads a vehicle, also those that know nothing of stops, doubt and what is under way: the speed
// asked for, speeds of legs and zones, and another vehicle's right of way.
#pragma once

#include "drive/route_follower.h"

namespace tessera::drive {

class PlainLimits {
public:
  PlainLimits(const FollowerSetup& setup, const Polyline& way);
  struct Allowed {
    SpeedLimit limit;
    bool waits;  ///< it has come to where it waits for others; the speed is 0 there
  };
  /// `late`: so much before a place it stops that is not to be passed.
  [[nodiscard]] Allowed at(Metres along, Metres late, const PredictedState& predicted) const;
  [[nodiscard]] const SpeedPlan& plan() const { return plan_; }

private:
  SpeedPlan plan_;
  StretchLimits legs_;
  std::shared_ptr<WayGuard> guard_;
};

}  // namespace tessera::drive
