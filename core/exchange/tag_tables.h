// Registered tags as tables: of tiles (serial,index,uid) and loose ones (x_m,y_m,uid). docs/site-format.md states both.
#pragma once

#include "exchange/preview.h"

namespace tessera::exchange {

/// Header `serial,index,uid`; index from 1 as the publication counts (id1 ... idn); an empty uid is a tag that is not
/// registered.
[[nodiscard]] std::string writeTileTags(const floor::Site& site);
/// Header `x_m,y_m,uid`.
[[nodiscard]] std::string writeLooseTags(const floor::Site& site);

/// Either table, told apart by its header (x,y stand for x_m,y_m). Tags that the table does not name stay as they are;
/// a loose tag that is there already moves. All or nothing. Error: names the file and the line.
[[nodiscard]] Result<Preview> importTags(const floor::Site& onto, std::string_view csv, const std::string& name);

}  // namespace tessera::exchange
