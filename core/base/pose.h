// Points, offsets and poses in the plane of the site frame (x, y as drawn; heading counter-clockwise from x).
#pragma once

#include <cmath>

#include "base/angle.h"
#include "base/units.h"

namespace tessera {

struct Point {
  Metres x;
  Metres y;
  constexpr bool operator==(const Point&) const = default;
};

/// A displacement between two points.
struct Offset {
  Metres x;
  Metres y;
  constexpr bool operator==(const Offset&) const = default;
};

constexpr Offset operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
constexpr Point operator+(Point p, Offset o) { return {p.x + o.x, p.y + o.y}; }
constexpr Point operator-(Point p, Offset o) { return {p.x - o.x, p.y - o.y}; }
constexpr Offset operator+(Offset a, Offset b) { return {a.x + b.x, a.y + b.y}; }
constexpr Offset operator*(double k, Offset o) { return {k * o.x, k * o.y}; }

[[nodiscard]] inline Metres length(Offset o) { return Metres{std::hypot(o.x.value(), o.y.value())}; }
[[nodiscard]] inline Metres distance(Point a, Point b) { return length(a - b); }
[[nodiscard]] inline Radians direction(Offset o) { return Radians{std::atan2(o.y.value(), o.x.value())}; }
[[nodiscard]] inline Offset turned(Offset o, Radians by) {
  const double c = cos(by);
  const double s = sin(by);
  return {c * o.x - s * o.y, s * o.x + c * o.y};
}

/// Where a vehicle's middle between the driven wheels is, and where its nose points.
struct Pose {
  Point position;
  Radians heading;
  constexpr bool operator==(const Pose&) const = default;
};

/// The site-frame place of a point given in vehicle axes (x forward, y left).
[[nodiscard]] inline Point placeOf(const Pose& vehicle, Offset inVehicle) {
  return vehicle.position + turned(inVehicle, vehicle.heading);
}

}  // namespace tessera
