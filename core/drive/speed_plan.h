// How fast a vehicle may go where: the speed asked for or its leg's or zone's, cut down before slower ones, corners and
// the route's end, by the radio's delay, and by doubt about its place (regulated pure pursuit, Macenski et al., arXiv
// 2305.20026, in the same spirit).
#pragma once

#include <limits>

#include "drive/command.h"

namespace tessera::drive {

/// Why the speed is what it is; the strictest reason.
enum class SpeedReason {
  Requested,
  Leg,
  SlowerLeg,
  Zone,
  SlowZone,
  Gate,
  Bend,
  Corner,
  End,
  Delay,
  Uncertainty,
  Heading
};

struct SpeedLimit {
  MetresPerSecond speed;
  SpeedReason reason = SpeedReason::Requested;
};
[[nodiscard]] inline SpeedLimit stricter(const SpeedLimit& a, const SpeedLimit& b) { return b.speed < a.speed ? b : a; }

struct SpeedPlanOptions {
  MetresPerSecond requested{0.12};
  Radians sharpCorner{0.35};    ///< from here on the vehicle stops at the vertex and turns on the spot
  double brakingShare = 0.5;    ///< of the vehicle's acceleration, used for planned braking
  MetresPerSecond creep{0.03};  ///< slowest speed short of standing; reaches a vertex in finite time
  Metres stopTolerance{0.008};  ///< a vertex counts as reached from here on: about the way that the braking still takes
  /// The last of the way to the route's end is driven no faster than this, so that readers try more often on it and the
  /// radio's delay is a shorter way; corners need no such care.
  Metres endApproach{0.08};
  MetresPerSecond endSpeed{0.04};
  double endPerSigma = 10.0;       ///< and no longer than so many times the doubt about the place
  Seconds settling{0.3};           ///< besides two delays: braking at the end, and the report that tells where that was
  Metres easySigma{0.03};          ///< up to this doubt about the place the speed is not cut
  Metres largestSigma{0.12};       ///< from this doubt on it creeps
  Radians easyHeadingSigma{0.06};  ///< up to this doubt about the heading the speed is not cut
  Radians largestHeadingSigma{0.12};  ///< from this doubt on it drives at ...
  double leastByHeading = 0.4;        ///< ... this share of the speed: only driving tells it its heading
  Metres shortestLook{0.15};          ///< look-ahead of the tracking law at low speed
  Metres endLook{0.08};               ///< the same before the route's end
  Metres longestLook{0.60};           ///< and at most
};

/// What the tracking law looks at, at this speed: as far as stability asks (vT/L <= 0.25, heading loop well damped).
[[nodiscard]] Metres lookAhead(MetresPerSecond speed, Seconds delay, const VehicleAbility& ability,
                               const SpeedPlanOptions& options);

/// Fastest speed that, held for the delay, can still be braked down to `goal` within the way.
[[nodiscard]] MetresPerSecond brakingSpeed(Metres way, MetresPerSecond goal, Seconds delay, MetresPerSecond2 braking);

class SpeedPlan {
public:
  SpeedPlan(const VehicleAbility& ability, const SpeedPlanOptions& options) : ability_{ability}, options_{options} {}

  struct Situation {
    Metres toStop;         ///< way left to the next vertex at which it stops
    bool stopIsEnd;        ///< that vertex is the route's end
    Seconds delay;         ///< what the command holds on for at least: period and jitter of the way there
    Metres sigma;          ///< doubt about the place
    Radians headingError;  ///< between the nose and the way to go
    /// What legs and slow zones allow, as StretchLimits has it.
    SpeedLimit stretch{MetresPerSecond{std::numeric_limits<double>::infinity()}, SpeedReason::Leg};
    Metres toGate{std::numeric_limits<double>::infinity()};  ///< way left to where it waits for others
    Radians headingSigma{};                                  ///< doubt about the heading
  };
  [[nodiscard]] SpeedLimit at(const Situation& situation) const;
  /// Whether a vehicle stops where the line turns by this much.
  [[nodiscard]] bool isSharp(Radians turn) const { return abs(turn) >= options_.sharpCorner; }
  /// What planned braking takes.
  [[nodiscard]] MetresPerSecond2 braking() const { return options_.brakingShare * ability_.acceleration; }
  /// The way in which it stops from its highest speed.
  [[nodiscard]] Metres stoppingWay(Seconds delay) const;
  [[nodiscard]] const SpeedPlanOptions& options() const { return options_; }
  [[nodiscard]] const VehicleAbility& ability() const { return ability_; }

private:
  VehicleAbility ability_;
  SpeedPlanOptions options_;
};

}  // namespace tessera::drive
