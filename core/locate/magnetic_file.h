// A magnetic map as bytes, to be kept: little-endian, with a check sum, the same for the same map.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "locate/magnetic_map.h"

namespace tessera::locate {

[[nodiscard]] std::vector<std::uint8_t> bytesOf(const MagneticMap& map);
/// Error: not such bytes, damaged, of a newer layout, or with numbers that no map has.
[[nodiscard]] Result<MagneticMap> magneticMapFrom(std::span<const std::uint8_t> bytes);

}  // namespace tessera::locate
