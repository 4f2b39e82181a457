// Heading and curvature of a chain of short legs that stands for a curve: taken over a window, so that a bend of it is
// spread over some way instead of standing in one point.
#pragma once

#include "base/polyline.h"
#include "base/rounded_line.h"
#include "drive/stretch_limits.h"

namespace tessera::drive {

class Bends {
public:
  /// Of `line` between two distances, beyond which its first and last legs are thought on.
  Bends(const Polyline& line, Metres from, Metres to, Metres window);
  [[nodiscard]] Radians heading(Metres along) const;
  /// In rad/m, positive to the left.
  [[nodiscard]] double curvature(Metres along) const;

private:
  [[nodiscard]] Point at(Metres along) const;

  const Polyline& line_;
  Metres from_;
  Metres to_;
  Metres window_;
};

/// How fast a way's bends let a vehicle go that turns no faster than `most`; bends from `sharp` on it takes standing.
/// A bend's turn is spread over half of the legs beside it, as the site check has it. Where the line has `arcs`, those
/// stretches hold instead.
[[nodiscard]] StretchLimits bendLimits(const Polyline& line, RadiansPerSecond most, Radians sharp,
                                       const std::vector<SpeedStretch>& arcs = {});
/// The arcs of a way, driven at a rate of turn, by the distance along another line that is so much farther on.
[[nodiscard]] std::vector<SpeedStretch> arcStretches(const RoundedLine& way, RadiansPerSecond rate, Metres farther);

/// A vehicle that holds headings turns no faster than this without slowing down by itself.
[[nodiscard]] RadiansPerSecond turnRateAtFullSpeed(const VehicleAbility& ability);
/// What it is told to turn at along arcs: it then slows down by itself, and still turns faster than at full speed.
[[nodiscard]] RadiansPerSecond turnRateOnArcs(const VehicleAbility& ability);
/// And at what it turns when it is told so, after slowing down by itself.
[[nodiscard]] RadiansPerSecond turnRateReached(RadiansPerSecond told, const VehicleAbility& ability);

}  // namespace tessera::drive
