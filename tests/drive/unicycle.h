// A unicycle without radio delay: it takes speed and turn rate 20 times a second, and has them 0.1 s late. The bench on
// which controllers are compared by what they are, whatever the radio does.
#pragma once

#include <string_view>

#include "drive/route_follower.h"

namespace tessera::test {

struct UnicycleRun {
  bool finished = false;
  double seconds = 0.0;
  double crossTrackRms = 0.0;  ///< m, of the whole drive
  double crossTrackMax = 0.0;
};

/// Five legs of 2 m; the four right angles between them (left, right, right, left) are rounded by this radius.
[[nodiscard]] floor::Route roundedRoute(double radius);
/// From the start, standing, to the end, at 0.5 m/s where the controller does not choose to go slower.
[[nodiscard]] UnicycleRun driveUnicycle(std::string_view follower, const floor::Route& route);

}  // namespace tessera::test
