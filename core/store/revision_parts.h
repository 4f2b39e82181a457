// A revision's site in three parts: its tiles with their tags, its picture, and the rest. A part is a site file of its
// own that holds nothing else, so that what one saving leaves alone is kept once. For this folder's sources.
#pragma once

#include <QByteArray>
#include <array>
#include <optional>

#include "base/result.h"
#include "floor/site.h"

namespace tessera::store {

enum class Part : std::size_t { Floor, Picture, Rest };
inline constexpr std::array kParts{Part::Floor, Part::Picture, Part::Rest};
inline constexpr std::array kPartColumns{"floor", "picture", "rest"};

/// What belongs to this part, copied; everything else is empty.
[[nodiscard]] floor::Site partOf(const floor::Site& site, Part part);
/// Moves what belongs to this part into the site.
void putPart(floor::Site& site, Part part, floor::Site from);

/// As text of a site file.
[[nodiscard]] QByteArray textOf(const floor::Site& site);
/// 160 bits.
[[nodiscard]] QByteArray digestOf(const QByteArray& text);
[[nodiscard]] QByteArray compressed(const QByteArray& text);
/// Nullopt: damaged, which the digest tells.
[[nodiscard]] std::optional<floor::Site> readPart(const QByteArray& compressed, const QByteArray& digest);

}  // namespace tessera::store
