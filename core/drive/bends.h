// Heading and curvature of a chain of short legs that stands for a curve: taken over a window, so that a bend of it is
// spread over some way instead of standing in one point.
#pragma once

#include "base/polyline.h"
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
/// A bend's turn is spread over half of the legs beside it, as the site check has it.
[[nodiscard]] StretchLimits bendLimits(const Polyline& line, RadiansPerSecond most, Radians sharp);

}  // namespace tessera::drive
