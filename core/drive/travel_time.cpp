#include "drive/travel_time.h"

#include <algorithm>
#include <cmath>

#include "drive/bends.h"
#include "drive/driven_way.h"

namespace tessera::drive {
namespace {

constexpr double kFinest = 0.01;  // m, in which the speed is taken for even
constexpr double kPieces = 20'000;
constexpr double kTurned = 0.087;  // rad: from here on the follower drives on

// The vehicle turns by headingGain times what is left, no faster than it can.
double turningTime(double turn, const VehicleAbility& ability) {
  const double linear = ability.maxTurnRate.value() / ability.headingGain;  // from this angle on at full rate
  double seconds = 0.0;
  if (turn > linear) {
    seconds += (turn - linear) / ability.maxTurnRate.value();
    turn = linear;
  }
  if (turn > kTurned) seconds += std::log(turn / kTurned) / ability.headingGain;
  return seconds;
}

}  // namespace

Seconds travelTime(const floor::Route& route, const VehicleAbility& ability, const SpeedPlanOptions& options,
                   Seconds delay, const StretchLimits& zones) {
  const RoundedLine way = drivenWay(route, ability, options);
  const Polyline& line = way.line();
  const SpeedPlan plan{ability, options};
  const StretchLimits limits = StretchLimits::ofLegs(route, way);
  const StretchLimits arcs{StretchLimits::Of::Bends,
                           arcStretches(way, turnRateReached(turnRateOnArcs(ability), ability), {})};
  double seconds = 0.0;
  double speed = 0.0;
  const double step = std::max(kFinest, line.length().value() / kPieces);
  for (std::size_t leg = 0; leg < line.legCount();) {
    std::size_t stop = leg + 1;
    while (stop < line.legCount() && !plan.isSharp(turnBetween(line.headingOf(stop - 1), line.headingOf(stop)))) ++stop;
    const bool end = stop == line.legCount();
    double left = (line.startOf(stop) - line.startOf(leg)).value();
    while (left > options.stopTolerance.value()) {
      const double piece = std::min(step, left);
      const Metres along = line.startOf(stop) - Metres{left};
      SpeedLimit stretch = limits.at(along, {}, delay + ability.lag, plan);
      for (const StretchLimits* others : {&zones, &arcs})
        stretch = stricter(stretch, others->at(along, {}, delay + ability.lag, plan));
      const double allowed = plan.at({Metres{left}, end, delay, Metres{}, Radians{}, stretch}).speed.value();
      const double next = std::min(allowed, std::sqrt(speed * speed + 2.0 * ability.acceleration.value() * piece));
      seconds += 2.0 * piece / (speed + next);
      speed = next;
      left -= piece;
    }
    speed = 0.0;
    if (!end)
      seconds += turningTime(std::abs(turnBetween(line.headingOf(stop - 1), line.headingOf(stop)).value()), ability);
    leg = stop;
  }
  // The first command has to reach it and its arrival to be heard of; at corners what is late on either side overlaps.
  // At the end it stands until it knows where.
  if (line.legCount() > 0) seconds += 4.0 * delay.value() + ability.lag.value() + options.settling.value();
  return Seconds{seconds};
}

}  // namespace tessera::drive
