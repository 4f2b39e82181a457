// Leads one vehicle along one route: from the state expected when the next command takes effect to that command, with
// the reason for it. Pure: no clock, no radio; one object per vehicle and drive.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "base/polyline.h"
#include "base/result.h"
#include "base/sentence.h"
#include "drive/command.h"
#include "drive/predictor.h"
#include "drive/speed_plan.h"
#include "drive/way_guard.h"

namespace tessera::drive {

enum class Phase {
  Approaching,  ///< on the way to the route's start, or back to where it left the route
  OnLeg,        ///< following a leg
  Turning,      ///< standing at a vertex, turning to the next leg
  Waiting,      ///< standing where it waits for others
  Finished,     ///< at the route's end, or past it; stands
  Lost,         ///< place unknown; stands
};

/// The state when the next command takes effect, and how long that command will hold on at least.
struct PredictedState {
  VehicleState state;
  Seconds delay;  ///< period of commands plus the part of the radio's delay that is not predicted; 0.1 to 1 s is usual
};

struct Decision {
  Command command;
  Phase phase = Phase::Lost;
  Metres progress;      ///< along the route; never falls while following
  Metres crossTrack;    ///< signed distance from the way to be driven, positive to its left
  Metres remaining;     ///< to the route's end
  std::size_t leg = 0;  ///< 0 for the first
  Point target;         ///< the point aimed at
  SpeedReason speedReason = SpeedReason::Requested;
  Radians headingError;  ///< from the state's heading to the command's
};

/// The heading to be held with which the heading loop of a vehicle that faces along `heading` turns at this rate, on
/// average until `delay` is over.
[[nodiscard]] Radians headingToTurn(RadiansPerSecond rate, Radians heading, Seconds delay,
                                    const VehicleAbility& ability);

/// One English sentence for the operator, e.g. "On leg 2 of 5, 0.34 m to go: 0.06 m/s, slowing down before the corner."
[[nodiscard]] Sentence sentence(const Decision& decision, const Polyline& route);

class RouteFollower {
public:
  virtual ~RouteFollower() = default;
  /// Does not allocate but when it lays a way to the route: at the start, and after the vehicle was carried. `now` must
  /// not fall from call to call.
  virtual Decision decide(const PredictedState& predicted, Seconds now) = 0;
  /// False: give it the state as it is known now; it is one of those that know nothing of the delay.
  [[nodiscard]] virtual bool wantsPrediction() const { return true; }
  [[nodiscard]] virtual const Polyline& route() const = 0;
  [[nodiscard]] virtual std::string_view name() const = 0;
};

struct FollowerSetup {
  floor::Route route;
  VehicleAbility ability;
  SpeedPlanOptions plan;                 ///< plan.requested is the speed asked for
  std::shared_ptr<WayGuard> guard = {};  ///< nullptr: the whole way is free
};

/// Names that makeRouteFollower knows; the first is the default.
[[nodiscard]] std::span<const std::string_view> followerNames();

/// Whether it takes the way of drivenWay; the others drive to the vertices, however far they may leave them.
[[nodiscard]] bool roundsCorners(std::string_view name);

/// Error: unknown name, a route of fewer than two different points or with numbers that are none, a requested speed
/// that is not positive or above the vehicle's.
[[nodiscard]] Result<std::unique_ptr<RouteFollower>> makeRouteFollower(std::string_view name,
                                                                       const FollowerSetup& setup);

}  // namespace tessera::drive
