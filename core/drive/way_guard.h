// What the floor and the other vehicles ask of whoever drives along a way: speeds of zones, and where to wait. The
// followers know this much of traffic, and traffic need not know how they follow.
#pragma once

#include "base/polyline.h"
#include "drive/stretch_limits.h"

namespace tessera::drive {

class WayGuard {
public:
  virtual ~WayGuard() = default;
  /// The way that is driven from now on: the route, or a way to it and what is left of it. Distances are along it.
  virtual void laid(const Polyline& way) = 0;
  [[nodiscard]] virtual const StretchLimits& limits() const = 0;
  /// How far a vehicle at `along` may go for now; infinite: to the end. `ahead`: within this way it can stop. Asking is
  /// what brings a vehicle its turn.
  [[nodiscard]] virtual Metres mayGoTo(Metres along, Metres ahead) = 0;
};

}  // namespace tessera::drive
