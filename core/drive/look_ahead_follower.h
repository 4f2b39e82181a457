// The default controller: aims at a point ahead on the line, as far away as speed and delay ask, slows down before
// corners and turns there on the spot, or rounds them where the vehicle may. Chains of short legs, which stand for
// curves, it follows by their curvature. It never drives backwards and never turns back for a point that it has passed.
#pragma once

#include <optional>

#include "drive/bends.h"
#include "drive/driven_way.h"
#include "drive/route_follower.h"
#include "drive/stretch_limits.h"

namespace tessera::drive {

class LookAheadFollower final : public RouteFollower {
public:
  static constexpr std::string_view kName = "look-ahead";

  explicit LookAheadFollower(const FollowerSetup& setup);

  Decision decide(const PredictedState& predicted, Seconds now) override;
  [[nodiscard]] const Polyline& route() const override { return way_.drawn(); }
  [[nodiscard]] std::string_view name() const override { return kName; }

private:
  /// The path: the way along the route from where it has been followed to, led up to by a straight leg when the vehicle
  /// is away.
  void layPath(Point from);
  void findStop();
  [[nodiscard]] Point aim(Metres look) const;
  /// What lies between the last stop and the next one, where it is a chain of legs.
  [[nodiscard]] Bends curve() const;
  [[nodiscard]] Radians holdOnCurve(const PredictedState& predicted, Radians course) const;
  [[nodiscard]] SpeedLimit speedLimit(const PredictedState& predicted, Radians error, Metres gate) const;
  [[nodiscard]] Metres lookAheadHere(const PredictedState& predicted) const;
  /// At the route's end: stands until it is known where it came to rest, and goes on to the end as slowly as it can.
  [[nodiscard]] Decision arrive(const PredictedState& predicted, Seconds now);
  [[nodiscard]] Decision stand(Phase phase, Radians heading, const VehicleState& state) const;
  /// The nearest point of the path ahead that may be meant, up to the next stop.
  [[nodiscard]] Polyline::Projection nearest(Point here) const;
  /// On the way, of the progress on the path; negative while the way is still to be reached.
  [[nodiscard]] Metres along() const { return progress_ - approach_ + skipped_; }
  void report(Decision& decision, const VehicleState& state) const;

  SpeedPlan plan_;
  RoundedLine way_;  ///< along the route
  StretchLimits legs_;
  std::shared_ptr<WayGuard> guard_;
  StretchLimits bends_;  ///< of the path
  Polyline path_;
  Metres approach_;        ///< length of the leg that leads up to the way
  Metres skipped_;         ///< distance on the way at which the approach ends
  Metres progress_;        ///< on the path
  Metres across_;          ///< from the path
  std::size_t begin_ = 0;  ///< vertex of the path at which it stood last
  std::size_t stop_ = 0;   ///< vertex of the path at which it stops next
  bool laid_ = false;
  bool turning_ = true;
  bool waiting_ = false;
  bool finished_ = false;
  std::optional<Seconds> stoodSince_;  ///< at the end
  bool inching_ = false;
  int inched_ = 0;
  Radians holding_;  ///< heading while it waits, and at the end
};

}  // namespace tessera::drive
