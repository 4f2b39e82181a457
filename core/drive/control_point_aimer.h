// The publication's controller, kept as the baseline: steers at the next control point from where the vehicle was last
// known to be, at the speed asked for or its leg's, and turns back for a point that it has missed.
#pragma once

#include <vector>

#include "drive/control_points.h"
#include "drive/plain_limits.h"

namespace tessera::drive {

class ControlPointAimer final : public RouteFollower {
public:
  static constexpr std::string_view kName = "control-points";

  ControlPointAimer(const FollowerSetup& setup, std::vector<ControlPoint> points);

  Decision decide(const PredictedState& predicted, Seconds now) override;
  [[nodiscard]] bool wantsPrediction() const override { return false; }
  [[nodiscard]] const Polyline& route() const override { return route_; }
  [[nodiscard]] std::string_view name() const override { return kName; }

private:
  Polyline route_;
  std::vector<ControlPoint> points_;
  PlainLimits limits_;
  std::size_t next_ = 0;
};

}  // namespace tessera::drive
