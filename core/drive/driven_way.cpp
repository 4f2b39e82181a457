#include "drive/driven_way.h"

namespace tessera::drive {

RoundedLine drivenWay(const floor::Route& route, const VehicleAbility& ability, const SpeedPlanOptions& options) {
  return {Polyline{route.vertices}, ability.cornerCut, options.sharpCorner};
}

}  // namespace tessera::drive
