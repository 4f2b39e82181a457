// The figure that tells most of a vehicle: two stars of seven points, one between the other's. Its legs cross the rows
// of tags at every slant, so that tags lie evenly across each reader's way, and it turns at every point.
#pragma once

#include <optional>
#include <vector>

#include "base/box.h"
#include "base/pose.h"

namespace tessera::calibrate {

inline constexpr Metres kLeastFigure{0.4};  ///< radius
inline constexpr Metres kMostFigure{1.5};

/// turn: of the first point, counter-clockwise from x.
[[nodiscard]] std::vector<Point> figure(Point centre, Metres radius, Radians turn);

struct FigurePlace {
  Point centre;
  Metres radius;
};
/// As large as it may be and as near to `wish` as it can be, `margin` away from the floor's edges; nullopt: the floor
/// is too small for it.
[[nodiscard]] std::optional<FigurePlace> placeFigure(const Box& floor, Point wish, Metres margin);

}  // namespace tessera::calibrate
