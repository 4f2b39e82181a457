// A first floor: so many tiles of one type, side by side.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/result.h"
#include "floor/site.h"

namespace tessera::floor {

/// The publication's sizes: 30, 45 and 60 cm, one-in-two and full, at the pitches that divide them.
[[nodiscard]] std::span<const TileType> usualTileTypes();

/// The small vehicle of the demo sites: 0.40 by 0.36 m, three readers. Without an address, a name and a key.
[[nodiscard]] VehicleSetup usualVehicle();

struct NewFloor {
  static constexpr int kMost = 1000;  ///< tiles in a row or column

  std::string name;
  TileType type;
  int columns = 5;  ///< tiles along x, 1 to kMost
  int rows = 4;     ///< tiles along y, 1 to kMost; 0 of both: an empty floor, its tiles are laid by hand
  /// Give every tag a made-up UID and put a vehicle in the middle, so that it can drive in the simulated world at once.
  /// False: no vehicles, and the tiles' tags are not registered yet.
  bool practice = false;
  bool operator==(const NewFloor&) const = default;
};

/// Serial numbers T-0001, ..., row by row from the lower left corner, which is the site's origin; one running zone over
/// all, and neither zone nor vehicle where there are no tiles. The same site for the same wish. Error: a count out of
/// range, or a type without tags.
[[nodiscard]] Result<Site> layNewFloor(const NewFloor& wish);

}  // namespace tessera::floor
