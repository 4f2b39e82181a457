// The words and numbers that a site file may use where only a few are allowed, in the order of their enumerators.
#pragma once

#include <array>
#include <string_view>

namespace tessera::floor {

inline constexpr std::array<std::string_view, 3> kPatternNames{"full", "one-in-two", "custom"};
inline constexpr std::array<std::string_view, 8> kZoneKindNames{"running", "storage", "parking", "charging",
                                                                "no-go",   "slow",    "one-way", "single-vehicle"};
inline constexpr std::array<int, 6> kAirRates{300, 1200, 2400, 4800, 9600, 19200};
inline constexpr std::array<int, 8> kBauds{1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200};

}  // namespace tessera::floor
