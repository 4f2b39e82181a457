#include "drive/bends.h"

#include <algorithm>
#include <cmath>

namespace tessera::drive {
namespace {

constexpr Metres kAtEnds{1e-5};  // of an arc, where the legs begin that it touches
constexpr double kOnArcs = 2.0;  // times the rate of turn at full speed; see the decision record on the controller

}  // namespace

Bends::Bends(const Polyline& line, Metres from, Metres to, Metres window)
    : line_{line}, from_{from}, to_{to}, window_{window} {}

Point Bends::at(Metres along) const {
  const Metres on = std::clamp(along, from_, to_);
  const Point place = line_.at(on);
  if (along == on) return place;
  // The leg that ends at `to` is the one before it.
  const std::size_t leg = along > on ? line_.legAt(to_ - Metres{1e-9}) : line_.legAt(from_);
  return place + turned({along - on, Metres{}}, line_.headingOf(leg));
}

Radians Bends::heading(Metres along) const { return direction(at(along + 0.5 * window_) - at(along - 0.5 * window_)); }

double Bends::curvature(Metres along) const {
  const Radians turn = turnBetween(heading(along - 0.5 * window_), heading(along + 0.5 * window_));
  return turn.value() / window_.value();
}

StretchLimits bendLimits(const Polyline& line, RadiansPerSecond most, Radians sharp,
                         const std::vector<SpeedStretch>& arcs) {
  std::vector<SpeedStretch> stretches;
  const auto ofArc = [&](Metres along, Radians turn) {
    return turn <= kArcBend + Radians{1e-6} && std::any_of(arcs.begin(), arcs.end(), [&](const SpeedStretch& arc) {
             return arc.from - kAtEnds <= along && along <= arc.to + kAtEnds;
           });
  };
  for (std::size_t v = 1; v < line.legCount(); ++v) {
    const Radians turn = abs(turnBetween(line.headingOf(v - 1), line.headingOf(v)));
    if (turn >= sharp || turn <= Radians{1e-6} || ofArc(line.startOf(v), turn)) continue;
    const Metres before = 0.5 * (line.startOf(v) - line.startOf(v - 1));
    const Metres behind = 0.5 * (line.startOf(v + 1) - line.startOf(v));
    const double curvature = turn.value() / (before + behind).value();
    stretches.push_back(
        {line.startOf(v) - before, line.startOf(v) + behind, MetresPerSecond{most.value() / curvature}});
  }
  stretches.insert(stretches.end(), arcs.begin(), arcs.end());
  return {StretchLimits::Of::Bends, std::move(stretches)};
}

std::vector<SpeedStretch> arcStretches(const RoundedLine& way, RadiansPerSecond rate, Metres farther) {
  std::vector<SpeedStretch> stretches;
  for (const RoundedLine::Arc& arc : way.arcs())
    stretches.push_back({arc.from + farther, arc.to + farther, MetresPerSecond{rate.value() * arc.radius.value()}});
  return stretches;
}

RadiansPerSecond turnRateAtFullSpeed(const VehicleAbility& ability) {
  return RadiansPerSecond{std::min(ability.maxTurnRate.value(), ability.headingGain * ability.fullSpeedError.value())};
}

RadiansPerSecond turnRateOnArcs(const VehicleAbility& ability) {
  return std::min(ability.maxTurnRate, kOnArcs * turnRateAtFullSpeed(ability));
}

// It turns at headingGain times its heading error, and drives the less of what it is told the larger that is: the rate
// at which both agree, told speed and rate being in proportion on an arc.
RadiansPerSecond turnRateReached(RadiansPerSecond told, const VehicleAbility& ability) {
  const double slowing = (ability.turnFirstError - ability.fullSpeedError).value();
  if (told <= turnRateAtFullSpeed(ability) || !(slowing > 0.0)) return told;
  const double rate = told.value() * ability.turnFirstError.value() / (slowing + told.value() / ability.headingGain);
  return std::min(told, RadiansPerSecond{rate});
}

}  // namespace tessera::drive
