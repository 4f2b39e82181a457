// How fast a vehicle may go where: the speed asked for, cut down before corners and the route's end, by the radio's
// delay, and by doubt about its place (regulated pure pursuit, Macenski et al., arXiv 2305.20026, in the same spirit).
#pragma once

#include <vector>

#include "base/polyline.h"
#include "drive/command.h"

namespace tessera::drive {

/// Why the speed is what it is; the strictest reason.
enum class SpeedReason { Requested, Corner, End, Delay, Uncertainty, Heading, Approach };

struct SpeedLimit {
  MetresPerSecond speed;
  SpeedReason reason = SpeedReason::Requested;
};

struct SpeedPlanOptions {
  MetresPerSecond requested{0.12};
  Radians sharpCorner{0.35};    ///< from here on the vehicle stops at the vertex and turns on the spot
  double brakingShare = 0.5;    ///< of the vehicle's acceleration, used for planned braking
  MetresPerSecond creep{0.03};  ///< slowest speed short of standing; reaches a vertex in finite time
  Metres stopTolerance{0.01};   ///< a stop counts as reached this far before the vertex
  Metres largestSigma{0.12};    ///< with more doubt than this it creeps
};

/// Speed along one route. The route's vertices where it has to stop are found once.
class SpeedPlan {
public:
  SpeedPlan(const Polyline& route, const VehicleAbility& ability, const SpeedPlanOptions& options);

  /// Distance of the next vertex at which the vehicle stops, at or after `along`; the route's length for the last.
  [[nodiscard]] Metres nextStop(Metres along) const;
  [[nodiscard]] bool stopsAt(std::size_t vertex) const { return stops_.at(vertex); }
  /// delay: what the command in force holds on for at least (update period and jitter of the way there); lookAhead: of
  /// the tracking law, which is stable below 0.25·lookAhead/delay.
  [[nodiscard]] SpeedLimit at(Metres along, Metres stop, Seconds delay, Metres lookAhead, Metres sigma) const;
  [[nodiscard]] const SpeedPlanOptions& options() const { return options_; }

private:
  std::vector<Metres> starts_;
  std::vector<bool> stops_;
  VehicleAbility ability_;
  SpeedPlanOptions options_;
};

}  // namespace tessera::drive
