#include "drive/bends.h"

#include <algorithm>
#include <cmath>

namespace tessera::drive {

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

StretchLimits bendLimits(const Polyline& line, RadiansPerSecond most, Radians sharp) {
  std::vector<SpeedStretch> stretches;
  for (std::size_t v = 1; v < line.legCount(); ++v) {
    const Radians turn = abs(turnBetween(line.headingOf(v - 1), line.headingOf(v)));
    if (turn >= sharp || turn <= Radians{1e-6}) continue;
    const Metres before = 0.5 * (line.startOf(v) - line.startOf(v - 1));
    const Metres behind = 0.5 * (line.startOf(v + 1) - line.startOf(v));
    const double curvature = turn.value() / (before + behind).value();
    stretches.push_back(
        {line.startOf(v) - before, line.startOf(v) + behind, MetresPerSecond{most.value() / curvature}});
  }
  return {StretchLimits::Of::Bends, std::move(stretches)};
}

}  // namespace tessera::drive
