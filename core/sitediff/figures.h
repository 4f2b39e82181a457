// A site in numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "floor/site.h"

namespace tessera::sitediff {

struct ZoneFigures {
  std::string name;
  floor::ZoneKind kind;
  double squareMetres;
};
struct RouteFigures {
  std::string name;
  Metres length;
  int stops;     ///< sharp corners at which a vehicle stops and turns, and the end
  Seconds time;  ///< as a vehicle alone on the floor would take
};

struct Figures {
  std::size_t tilesKnown = 0;
  std::size_t tilesLaid = 0;
  std::size_t tagPlaces = 0;  ///< of the laid tiles
  std::size_t registered = 0;
  std::size_t looseTags = 0;
  double floorSquareMetres = 0;  ///< under tiles
  std::vector<ZoneFigures> zones;
  std::vector<RouteFigures> routes;
  std::size_t vehicles = 0;
};

/// speed: asked for on the routes; none: the highest of the first vehicle. Travel times reckon with the first vehicle's
/// acceleration, half of it for braking, a stop and a turn on the spot at sharp corners, and slow zones.
[[nodiscard]] Figures figuresOf(const floor::Site& site, std::optional<MetresPerSecond> speed = {});

}  // namespace tessera::sitediff
