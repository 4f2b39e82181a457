// A chain of straight legs, measured by the distance travelled along it.
#pragma once

#include <cstddef>
#include <vector>

#include "base/pose.h"

namespace tessera {

/// Immutable; legs of zero length are dropped. Empty and single-point lines are allowed and have length zero.
class Polyline {
public:
  struct Projection {
    Metres along;     ///< distance from the start to the nearest point
    Metres across;    ///< signed distance from the line, positive to its left
    std::size_t leg;  ///< index of the leg on which the nearest point lies
    Point nearest;
  };

  Polyline() = default;
  explicit Polyline(const std::vector<Point>& vertices);

  [[nodiscard]] const std::vector<Point>& vertices() const { return vertices_; }
  [[nodiscard]] bool empty() const { return vertices_.empty(); }
  [[nodiscard]] std::size_t legCount() const { return vertices_.size() < 2 ? 0 : vertices_.size() - 1; }
  [[nodiscard]] Metres length() const { return starts_.empty() ? Metres{} : starts_.back(); }
  /// Distance from the start to a vertex.
  [[nodiscard]] Metres startOf(std::size_t vertex) const { return starts_.at(vertex); }
  [[nodiscard]] Radians headingOf(std::size_t leg) const;
  /// The leg at a distance; at a vertex the one that begins there. Distances are clamped to the line.
  [[nodiscard]] std::size_t legAt(Metres along) const;
  [[nodiscard]] Point at(Metres along) const;
  /// Nearest point among distances in [from, to]; the earlier one of two equally near. Requires a non-empty line.
  [[nodiscard]] Projection project(Point p, Metres from, Metres to) const;
  [[nodiscard]] Projection project(Point p) const { return project(p, Metres{}, length()); }

private:
  std::vector<Point> vertices_;
  std::vector<Metres> starts_;
};

}  // namespace tessera
