// Regulated Pure Pursuit, kept as a baseline: an arc to the point that the look-ahead's circle meets on the line,
// slower in tight arcs and near the end (Macenski, Singh, Martín, Ginés: Regulated Pure Pursuit for Robot Path
// Tracking, Autonomous Robots 47, 2023, arXiv 2305.20026). Its look-ahead is tuned to 0.3 m; the rest is as published,
// without the costs of obstacles, which nobody sees here. It knows nothing of the radio's delay.
#pragma once

#include "drive/plain_limits.h"

namespace tessera::drive {

class RegulatedPurePursuit final : public RouteFollower {
public:
  static constexpr std::string_view kName = "regulated-pure-pursuit";

  explicit RegulatedPurePursuit(const FollowerSetup& setup);

  Decision decide(const PredictedState& predicted, Seconds now) override;
  [[nodiscard]] bool wantsPrediction() const override { return false; }
  [[nodiscard]] const Polyline& route() const override { return route_; }
  [[nodiscard]] std::string_view name() const override { return kName; }

private:
  [[nodiscard]] Point carrot(Point here) const;
  void steer(Decision& decision, const PredictedState& predicted) const;

  Polyline route_;
  PlainLimits limits_;
  Metres progress_;
  bool finished_ = false;
};

}  // namespace tessera::drive
