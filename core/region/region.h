// An area of the floor: any number of polygons with holes. Kept in whole micrometres, so that touching edges touch
// exactly and no rounding makes an area where there is none.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/box.h"

namespace tessera::region {

/// Micrometres from the site's origin.
struct Node {
  std::int64_t x = 0;
  std::int64_t y = 0;
  bool operator==(const Node&) const = default;
};
using Ring = std::vector<Node>;

/// Part of a straight way, as shares of it from 0 to 1.
struct Stretch {
  double from = 0;
  double to = 1;
};

/// What is no number counts as 0, what is farther than 1000 km from the origin as 1000 km.
[[nodiscard]] Node nodeOf(Point p);
[[nodiscard]] Point pointOf(Node n);

class Region {
public:
  Region() = default;
  /// The inside of a closed outline; where it crosses itself, what is inside an odd number of times. Fewer than three
  /// different points: empty.
  [[nodiscard]] static Region of(std::span<const Point> outline);
  [[nodiscard]] static Region of(const Box& box);
  [[nodiscard]] static Region unionOf(std::span<const Region> parts);
  /// The union of many boxes, quick where most stand side by side.
  [[nodiscard]] static Region unionOf(std::span<const Box> boxes);

  friend Region operator|(const Region& a, const Region& b);
  friend Region operator&(const Region& a, const Region& b);
  friend Region operator-(const Region& a, const Region& b);
  /// With a border of that width all around, corners kept square; negative: without it.
  [[nodiscard]] Region grown(Metres by) const;
  /// Without what is narrower than `width` anywhere.
  [[nodiscard]] Region opened(Metres width) const;
  /// Everything that the region covers while it is carried along a straight way.
  [[nodiscard]] Region swept(Offset way) const;

  [[nodiscard]] bool empty() const { return rings_.empty(); }
  [[nodiscard]] double squareMetres() const;
  /// Parts that do not touch one another along a line, each with its holes; from the lowest, then leftmost, on.
  [[nodiscard]] std::vector<Region> pieces() const;
  /// Requires a region that is not empty.
  [[nodiscard]] Box bounds() const;
  /// The edge itself counts as inside.
  [[nodiscard]] bool contains(Point p) const;
  /// The nearest point of any outline or hole. Requires a region that is not empty.
  [[nodiscard]] Point nearestOnEdge(Point p) const;
  /// The stretches of the straight way that lie inside, in order.
  [[nodiscard]] std::vector<Stretch> within(Point from, Point to) const;

  /// Outlines counter-clockwise, holes clockwise.
  [[nodiscard]] const std::vector<Ring>& rings() const { return rings_; }
  bool operator==(const Region&) const = default;

private:
  friend struct ClipperBridge;
  std::vector<Ring> rings_;
};

}  // namespace tessera::region
