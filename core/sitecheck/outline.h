// Outlines and lines as they were drawn, before they are taken for areas.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/pose.h"

namespace tessera::sitecheck {

/// Without points that follow their like (to the micrometre); of a closed line also without a last point like the
/// first.
[[nodiscard]] std::vector<Point> withoutRepeats(std::span<const Point> line, bool closed);

/// Signed area by the order of the points, m²: what a line encloses twice counts twice.
[[nodiscard]] double drawnArea(std::span<const Point> outline);

/// Where two edges of a closed line cross, the earliest edge's first; edges that only touch do not cross.
[[nodiscard]] std::optional<Point> firstCrossing(std::span<const Point> outline);

}  // namespace tessera::sitecheck
