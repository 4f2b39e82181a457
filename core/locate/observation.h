// What a vehicle tells about its own movement and the tags under its readers, with instants on the host's clock.
// Nothing else reaches a locator: no true pose, no command.
#pragma once

#include "base/units.h"
#include "floor/tag.h"

namespace tessera::locate {

/// The tag was inside the reader's disc at the instant `at`. Either every read or only the first of each visit may be
/// passed on: a read of the tag that the reader already held counts as "still there".
struct TagRead {
  int reader = 0;  ///< index into VehicleSetup::readers
  floor::TagUid uid;
  Seconds at;
};

/// The reader saw its tag for the last time at the instant `at`, and none at its next attempts.
struct TagLeft {
  int reader = 0;
  Seconds at;
};

/// One sample of the vehicle's own motion.
struct Motion {
  Seconds at;
  Metres travel;          ///< odometer, unwrapped: forwards minus backwards since any fixed start
  MetresPerSecond speed;  ///< negative backwards
  Radians heading;        ///< site frame, from the vehicle's compass and wheel filter; carries the compass' bias
};

}  // namespace tessera::locate
