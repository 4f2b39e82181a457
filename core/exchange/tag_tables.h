// Registered tags as tables: of tiles (serial,index,uid) and by their places (x_m,y_m,uid). docs/site-format.md states
// both.
#pragma once

#include "exchange/preview.h"

namespace tessera::exchange {

/// Header `serial,index,uid`; index from 1 as the publication counts (id1 ... idn); an empty uid is a tag that is not
/// registered.
[[nodiscard]] std::string writeTileTags(const floor::Site& site);
/// Header `x_m,y_m,uid`: every registered tag that has a place, those of laid tiles first, then the loose ones. Tiles'
/// tags to the micrometre, loose tags with the fewest digits that read back exactly.
[[nodiscard]] std::string writeTagPlaces(const floor::Site& site);

/// What tags of the site the one and the other table lack, a sentence for each kind.
[[nodiscard]] std::vector<Sentence> leftOutOfTileTags(const floor::Site& site);
[[nodiscard]] std::vector<Sentence> leftOutOfTagPlaces(const floor::Site& site);

/// How far from a tile's tag a place of a table may be to mean that tag.
inline constexpr Metres kSamePlace{0.01};

/// Either table, told apart by its header (x,y stand for x_m,y_m). Tags that the table does not name stay as they are;
/// a loose tag that is there already moves. A place where a laid tile has a tag is that tag's, whose UID is set; any
/// other becomes a loose tag. All or nothing. Error: names the file and the line.
[[nodiscard]] Result<Preview> importTags(const floor::Site& onto, std::string_view csv, const std::string& name);

}  // namespace tessera::exchange
