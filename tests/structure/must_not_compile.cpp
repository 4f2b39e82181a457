// One wrong use of units each, chosen by a macro; without any macro the file is right and compiles.
#include "base/ids.h"
#include "base/pose.h"

namespace tessera {

Metres travelled(Seconds time) { return MetresPerSecond{0.5} * time; }

Metres right = Metres{1.0} + travelled(Seconds{2.0});
bool before = Seconds{1.0} < Seconds{2.0};

#if defined(METRES_PLUS_RADIANS)
auto wrong = Metres{1.0} + Radians{1.0};
#elif defined(METRES_FROM_RADIANS)
Metres wrong = Radians{1.0};
#elif defined(METRES_FROM_DOUBLE)
Metres wrong = 1.0;
#elif defined(DOUBLE_FROM_METRES)
double wrong = Metres{1.0};
#elif defined(SPEED_FOR_TIME)
Metres wrong = travelled(MetresPerSecond{2.0});
#elif defined(METRES_BELOW_SECONDS)
bool wrong = Metres{1.0} < Seconds{1.0};
#elif defined(VEHICLE_FROM_COUNT)
VehicleId wrong = 3;
#endif

}  // namespace tessera
