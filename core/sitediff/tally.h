// How much changed on the way from one site to another, in numbers: for a line of a table.
#pragma once

#include "floor/site.h"

namespace tessera::sitediff {

struct Tally {
  int laid = 0;     ///< tiles
  int moved = 0;    ///< tiles, turned ones included
  int takenUp = 0;  ///< tiles
  int tags = 0;     ///< registered, cleared, replaced or moved
  int zones = 0;    ///< new, gone or changed; likewise below
  int routes = 0;
  int vehicles = 0;
  int others = 0;  ///< tile types, tiles that are known, the site's name, radio, north, picture
  [[nodiscard]] bool empty() const { return *this == Tally{}; }
  bool operator==(const Tally&) const = default;
};

[[nodiscard]] Tally tallyOf(const floor::Site& before, const floor::Site& after);

}  // namespace tessera::sitediff
