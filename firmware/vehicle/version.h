// The firmware's own version, as Identity tells it. It grows apart from the desktop's.
#pragma once

#include <cstdint>

namespace tessera::firmware {

inline constexpr std::uint8_t kFirmwareMajor = 0;
inline constexpr std::uint8_t kFirmwareMinor = 1;
inline constexpr std::uint8_t kFirmwarePatch = 0;

}  // namespace tessera::firmware
