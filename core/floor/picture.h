// Pictures that a site carries: which are taken, and their bytes as text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/units.h"

namespace tessera::floor {

/// The longest picture, in bytes.
inline constexpr std::size_t kMostPicture = 20'000'000;

/// Of a backdrop's pixel: a drawing of a screw to one of a country.
inline constexpr Metres kLeastBackdropPixel{1e-5};
inline constexpr Metres kMostBackdropPixel{100.0};

/// Begins as every PNG or JPEG file does. Whether the rest can be shown is known to who decodes it.
[[nodiscard]] bool isPicture(std::string_view bytes);

/// Base64 (RFC 4648) in one line.
[[nodiscard]] std::string toBase64(std::string_view bytes);
/// Nullopt: not the text that toBase64() gives for any bytes.
[[nodiscard]] std::optional<std::string> fromBase64(std::string_view text);

}  // namespace tessera::floor
