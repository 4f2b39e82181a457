// What the tests of traffic share: two vehicles and their body.
#pragma once

#include "base/ids.h"
#include "traffic/body_box.h"

namespace tessera::traffic {

inline constexpr VehicleId kOne{1}, kTwo{2}, kThree{3};
inline constexpr BodyBox kBody{Metres{0.30}, Metres{0.10}, Metres{0.20}, Metres{0.20}};
inline Point at(double x, double y) { return {Metres{x}, Metres{y}}; }

}  // namespace tessera::traffic
