// The room that a vehicle takes, as an upright box in its own axes around the middle between its driven wheels.
#pragma once

#include <vector>

#include "base/pose.h"
#include "floor/site.h"

namespace tessera::traffic {

struct BodyBox {
  Metres front;
  Metres back;  ///< behind the middle, positive
  Metres left;
  Metres right;  ///< positive

  [[nodiscard]] BodyBox grown(Metres by) const { return {front + by, back + by, left + by, right + by}; }
  /// Of its corner farthest from the middle: what it needs to turn on the spot.
  [[nodiscard]] Metres reach() const;
  [[nodiscard]] std::vector<Point> at(const Pose& pose) const;
  /// All that it covers on a straight way, its nose ahead.
  [[nodiscard]] std::vector<Point> along(Point from, Point to) const;
};

/// Around the footprint; around the wheels where the site gives no footprint.
[[nodiscard]] BodyBox bodyBoxOf(const floor::VehicleSetup& setup);

}  // namespace tessera::traffic
