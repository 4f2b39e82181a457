// The one place where a compass' clockwise bearing and the site's counter-clockwise heading are turned into each other.
#pragma once

#include <cstdint>

#include "base/angle.h"

namespace tessera::floor {

/// Site heading of a bearing clockwise from north. northToY: see Site.
[[nodiscard]] inline Radians headingOfBearing(Radians bearing, Radians northToY) {
  return wrapped(Radians{kPi / 2} - (bearing - northToY));
}

/// Bearing clockwise from north of a site heading.
[[nodiscard]] inline Radians bearingOfHeading(Radians heading, Radians northToY) {
  return wrapped(northToY + Radians{kPi / 2} - heading);
}

/// Wire unit of bearings: 1/65536 turn.
[[nodiscard]] inline Radians fromBinaryAngle(std::uint16_t b) { return wrapped(Radians{b * (2 * kPi / 65536.0)}); }
[[nodiscard]] inline std::uint16_t toBinaryAngle(Radians a) {
  return static_cast<std::uint16_t>(static_cast<std::int32_t>(std::lround(wrapped(a).value() * 65536.0 / (2 * kPi))));
}

}  // namespace tessera::floor
