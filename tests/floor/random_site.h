// Sites of every shape that the format allows, from a seed.
#pragma once

#include <cstdint>

#include "floor/site.h"

namespace tessera::floor {

[[nodiscard]] Site randomSite(std::uint64_t seed);

}  // namespace tessera::floor
