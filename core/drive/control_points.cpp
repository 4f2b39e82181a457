#include "drive/control_points.h"

#include <cmath>

namespace tessera::drive {
namespace {

constexpr double kMostPoints = 100'000;
constexpr double kRounding = 1e-9;  // a leg of 3 d has three intervals even when 0.6 / 0.2 falls short of 3

}  // namespace

Result<std::vector<ControlPoint>> controlPoints(const Polyline& route, Metres spacing) {
  if (!(spacing > Metres{0.0}) || !std::isfinite(spacing.value()))
    return failure("The distance of control points must be a positive number of metres.");
  if (route.legCount() == 0) return failure("A route needs at least two different points.");
  if (!(route.length() / spacing + static_cast<double>(route.legCount()) < kMostPoints))
    return failure("The route is too long for control points so close together.");

  std::vector<ControlPoint> points{{route.vertices().front(), Metres{}, true}};
  for (std::size_t leg = 0; leg < route.legCount(); ++leg) {
    const Metres start = route.startOf(leg);
    const Metres end = route.startOf(leg + 1);
    const double intervals = (end - start) / spacing;
    double inner = std::floor(intervals + kRounding);
    // The last one gives way to the vertex when only a rest would part them.
    if (inner >= 1.0 && intervals - inner < 0.25) inner -= 1.0;
    for (double n = 1.0; n <= inner; n += 1.0) {
      const Offset unit = turned({Metres{1.0}, Metres{}}, route.headingOf(leg));
      points.push_back({route.vertices()[leg] + n * spacing.value() * unit, start + spacing * n, false});
    }
    points.push_back({route.vertices()[leg + 1], end, true});
  }
  return points;
}

}  // namespace tessera::drive
