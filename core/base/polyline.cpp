#include "base/polyline.h"

#include <algorithm>
#include <limits>

namespace tessera {

Polyline::Polyline(const std::vector<Point>& vertices) {
  for (const Point& v : vertices) {
    if (!vertices_.empty() && distance(vertices_.back(), v) <= Metres{0.0}) continue;
    starts_.push_back(vertices_.empty() ? Metres{} : starts_.back() + distance(vertices_.back(), v));
    vertices_.push_back(v);
  }
}

Radians Polyline::headingOf(std::size_t leg) const { return direction(vertices_.at(leg + 1) - vertices_.at(leg)); }

std::size_t Polyline::legAt(Metres along) const {
  if (legCount() == 0) return 0;
  const auto after = std::upper_bound(starts_.begin(), starts_.end(), along);
  const auto index = static_cast<std::size_t>(std::distance(starts_.begin(), after));
  return std::clamp<std::size_t>(index, 1, legCount()) - 1;
}

Point Polyline::at(Metres along) const {
  if (legCount() == 0) return vertices_.empty() ? Point{} : vertices_.front();
  const Metres clamped = std::clamp(along, Metres{}, length());
  const std::size_t leg = legAt(clamped);
  const double part = (clamped - starts_[leg]) / (starts_[leg + 1] - starts_[leg]);
  return vertices_[leg] + part * (vertices_[leg + 1] - vertices_[leg]);
}

Polyline::Projection Polyline::project(Point p, Metres from, Metres to) const {
  if (legCount() == 0) return {Metres{}, distance(vertices_.front(), p), 0, vertices_.front()};
  from = std::clamp(from, Metres{}, length());
  to = std::clamp(to, from, length());
  Projection best{};
  Metres bestDistance{std::numeric_limits<double>::infinity()};
  for (std::size_t leg = legAt(from); leg < legCount() && starts_[leg] <= to; ++leg) {
    const Offset unit = turned({Metres{1.0}, Metres{}}, headingOf(leg));
    const Offset toPoint = p - vertices_[leg];
    const Metres dot{toPoint.x.value() * unit.x.value() + toPoint.y.value() * unit.y.value()};
    const Metres low = std::max(from - starts_[leg], Metres{});
    const Metres high = std::min(to, starts_[leg + 1]) - starts_[leg];
    const Metres on = std::clamp(dot, low, std::max(low, high));
    const Point nearest = vertices_[leg] + on.value() * unit;
    if (const Metres d = distance(nearest, p); d < bestDistance) {
      bestDistance = d;
      const double cross = unit.x.value() * toPoint.y.value() - unit.y.value() * toPoint.x.value();
      best = {starts_[leg] + on, Metres{cross < 0 ? -d.value() : d.value()}, leg, nearest};
    }
  }
  return best;
}

}  // namespace tessera
