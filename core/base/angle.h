// Angles on the circle. Site headings run counter-clockwise from the site's x axis.
#pragma once

#include <cmath>
#include <numbers>

#include "base/units.h"

namespace tessera {

inline constexpr double kPi = std::numbers::pi;

/// The same direction in (-pi, pi].
[[nodiscard]] inline Radians wrapped(Radians a) {
  const double w = std::remainder(a.value(), 2.0 * kPi);
  return Radians{w <= -kPi ? kPi : w};
}

/// The shortest turn that leads from `from` to `to`, in (-pi, pi]; positive is counter-clockwise.
[[nodiscard]] inline Radians turnBetween(Radians from, Radians to) { return wrapped(to - from); }

[[nodiscard]] inline double sin(Radians a) { return std::sin(a.value()); }
[[nodiscard]] inline double cos(Radians a) { return std::cos(a.value()); }
[[nodiscard]] constexpr double degrees(Radians a) { return a.value() * 180.0 / kPi; }
[[nodiscard]] constexpr Radians fromDegrees(double d) { return Radians{d * kPi / 180.0}; }

}  // namespace tessera
