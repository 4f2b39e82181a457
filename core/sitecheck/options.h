// From where on the check calls something a fault.
#pragma once

#include <cstddef>

#include "base/units.h"

namespace tessera::sitecheck {

struct CheckOptions {
  /// Tiles are laid to about this; less is nobody's fault.
  Metres exact{0.0005};
  /// Up to this a gap or an overlap between tiles is a tile laid a little off, beyond it a hole in the floor or a tile
  /// upon another. Half the smallest usual pitch would already move a tag's place beyond its reader's disc.
  Metres seam{0.03};
  /// Smallest hole in a running zone's floor that is told, m²: a tenth by a tenth of a metre.
  double leastGap = 0.01;
  /// Longest way without a tag that the locator can bridge. Odometry is off by up to 10 % of the way and heading by
  /// 2° + 2°, which is 7 % across; the locator lets a vehicle creep at 12 cm of doubt: 0.12 m / 0.10 = 1.2 m, two
  /// tiles.
  Metres longestBlind{1.2};
  /// From this turn on a vehicle stops at a vertex and turns on the spot (drive::SpeedPlanOptions::sharpCorner).
  Radians sharpCorner{0.35};
  /// Parts of a zone are joined by a passage no narrower than this.
  Metres passage{0.10};
  /// Room that a vehicle's outline is to keep all around from what it must not touch, beyond where it may be.
  Metres clearance{0.0};
  /// A vehicle that is commanded less often than this drives in jerks: it stops by itself in between.
  Seconds longestRound{1.0};
  /// Of each kind so many are told one by one; the rest in one sentence, whose fault stands for them.
  std::size_t mostOfAKind = 1000;
  bool operator==(const CheckOptions&) const = default;
};

}  // namespace tessera::sitecheck
