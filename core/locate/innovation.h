// How far a tag lay from where it was expected when its read came: the innovation of the read, and its normalised
// square (NIS). A locator whose doubt is honest has a NIS of 2 on average (Bar-Shalom, Li, Kirubarajan, "Estimation
// with Applications to Tracking and Navigation", 5.4.2). Watches locators from outside: it is the same for all of them.
#pragma once

#include "base/pose.h"
#include "locate/locator.h"

namespace tessera::locate {

struct Innovation {
  Seconds at;
  int reader = 0;
  // From where the tag was expected, in vehicle axes: positive ahead and to the left.
  Metres ahead;
  Metres aside;
  double nis = 0.0;
  bool operator==(const Innovation&) const = default;
};

/// A read's result waits for the bus before it is told with an instant: so much older is what it tells of.
inline constexpr Seconds kReadLag{0.020};

/// Where in its disc a reader first reads a tag, seen from the reader and along the vehicle.
struct InDisc {
  Metres ahead;        ///< on average
  double along = 0.0;  ///< variances, m²
  double across = 0.0;
};
/// A reader that drives on meets its tag at the front rim of its disc, one that turns on any side of the rim; one that
/// stands has it anywhere in the disc. swing: of the reader, by the vehicle's turning.
[[nodiscard]] InDisc inDisc(Metres radius, MetresPerSecond speed, MetresPerSecond swing);

/// before: the belief at kReadLag before the read, to which the read is unknown. mount: of the reader, in vehicle axes.
[[nodiscard]] Innovation innovationOf(const Estimate& before, Offset mount, Metres radius, Point tag);

/// Bounds within which the mean of `count` independent values of NIS (or of a place's NEES) lies in 95 of 100 cases
/// when the doubt is honest. count: 1 or more.
struct MeanBounds {
  double low = 0.0;
  double high = 0.0;
};
[[nodiscard]] MeanBounds meanBounds(int count);

}  // namespace tessera::locate
