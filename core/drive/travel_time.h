// How long a drive along a route will take, before anybody drives it.
#pragma once

#include "drive/stretch_limits.h"

namespace tessera::drive {

/// Of a vehicle that stands at the route's start, faces along it and always knows its place: what the speed plan
/// allows, the vehicle's ramps, and the turns on the spot, or the arcs, at sharp corners. `delay` is what a command
/// holds on for at least (SpeedPlan::Situation), `zones` what slow zones ask of the way really driven (drivenWay).
/// Nothing for a route without two different points.
[[nodiscard]] Seconds travelTime(const floor::Route& route, const VehicleAbility& ability,
                                 const SpeedPlanOptions& options, Seconds delay, const StretchLimits& zones = {});

}  // namespace tessera::drive
