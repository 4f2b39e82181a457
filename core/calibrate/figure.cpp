#include "calibrate/figure.h"

#include <algorithm>
#include <cmath>

namespace tessera::calibrate {

std::vector<Point> figure(Point centre, Metres radius, Radians turn) {
  std::vector<Point> points;
  for (int i = 0; i < 15; ++i) {
    const double at = turn.value() + 2.0 * kPi * (3.0 * i + (i > 7 ? 0.5 : 0.0)) / 7.0;
    points.push_back(centre + Offset{std::cos(at) * radius, std::sin(at) * radius});
  }
  return points;
}

std::optional<FigurePlace> placeFigure(const Box& floor, Point wish, Metres margin) {
  const Metres room = 0.5 * std::min(floor.high.x - floor.low.x, floor.high.y - floor.low.y) - margin;
  if (room < kLeastFigure) return std::nullopt;
  const Metres radius = std::min(room, kMostFigure);
  const Metres away = radius + margin;
  return FigurePlace{{std::clamp(wish.x, floor.low.x + away, floor.high.x - away),
                      std::clamp(wish.y, floor.low.y + away, floor.high.y - away)},
                     radius};
}

}  // namespace tessera::calibrate
