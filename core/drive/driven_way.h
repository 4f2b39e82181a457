// The way that a vehicle takes along a route: the line drawn, its sharp corners rounded as far as the vehicle may leave
// them. Distances for the operator are along the line drawn, those of who leads and lets pass along the way.
#pragma once

#include "base/rounded_line.h"
#include "drive/speed_plan.h"

namespace tessera::drive {

[[nodiscard]] RoundedLine drivenWay(const floor::Route& route, const VehicleAbility& ability,
                                    const SpeedPlanOptions& options = {});

}  // namespace tessera::drive
