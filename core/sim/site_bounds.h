// How far a site's floor reaches, for what the world puts on it and around it.
#pragma once

#include <optional>

#include "floor/site.h"
#include "sim/rangers.h"

namespace tessera::sim {

struct Bounds {
  Point lowerLeft;
  Point upperRight;
};

/// The smallest upright rectangle around all tiles, loose tags and routes; nullopt for an empty site.
[[nodiscard]] std::optional<Bounds> boundsOf(const floor::Site& site);

/// Four walls, `margin` outside the site's bounds; none for an empty site.
[[nodiscard]] Scene roomAround(const floor::Site& site, Metres margin);

}  // namespace tessera::sim
