// Sites as *.tessera.json files. docs/site-format.md and docs/site.schema.json describe the format: lengths in metres,
// headings in degrees, the unit in each key's name.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"
#include "floor/site.h"

namespace tessera::floor {

inline constexpr int kSiteFormatVersion = 1;
// What a file may hold of a kind.
inline constexpr std::size_t kMostTileTypes = 1000;
inline constexpr std::size_t kMostTiles = 1'000'000;  ///< of loose tags as well
inline constexpr std::size_t kMostRoutes = 10'000;    ///< of zones as well
inline constexpr std::size_t kMostVehicles = 254;

/// Error: names `name` (the file), the JSON pointer or the line and column, and what was expected there. Texts from
/// anywhere are safe to give: size, depth and every number are bounded.
[[nodiscard]] Result<Site> parseSite(std::string_view text, const std::string& name);

/// The same text for equal sites; reading it back and writing it again gives the same bytes. The site must be one that
/// parseSite could have given (ranges of the format).
[[nodiscard]] std::string writeSite(const Site& site);

/// Error: the file cannot be read, or parseSite's.
[[nodiscard]] Result<Site> loadSite(const std::filesystem::path& path);

/// Writes a temporary file beside `path`, syncs it and renames it: after a failure or a power cut either the old file
/// or the new one stands there whole. Error: what could not be written and why; the old file stands untouched.
[[nodiscard]] Result<void> saveSite(const Site& site, const std::filesystem::path& path);

}  // namespace tessera::floor
