#include "traffic/body_box.h"

#include <algorithm>

namespace tessera::traffic {

Metres BodyBox::reach() const { return length(Offset{std::max(front, back), std::max(left, right)}); }

std::vector<Point> BodyBox::at(const Pose& pose) const {
  return {placeOf(pose, {-1.0 * back, -1.0 * right}), placeOf(pose, {front, -1.0 * right}),
          placeOf(pose, {front, left}), placeOf(pose, {-1.0 * back, left})};
}

std::vector<Point> BodyBox::along(Point from, Point to) const {
  const Radians heading = direction(to - from);
  const std::vector<Point> start = at({from, heading});
  const std::vector<Point> end = at({to, heading});
  return {start[0], end[1], end[2], start[3]};
}

BodyBox bodyBoxOf(const floor::VehicleSetup& setup) {
  const Metres wheel = 0.5 * setup.wheelDiameter;
  const Metres side = 0.5 * setup.track;
  BodyBox box{wheel, wheel, side, side};
  if (setup.footprint.empty()) return box;
  const Point first = setup.footprint.front();
  box = {first.x, -1.0 * first.x, first.y, -1.0 * first.y};
  for (const Point& p : setup.footprint)
    box = {std::max(box.front, p.x), std::max(box.back, -1.0 * p.x), std::max(box.left, p.y),
           std::max(box.right, -1.0 * p.y)};
  return box;
}

}  // namespace tessera::traffic
