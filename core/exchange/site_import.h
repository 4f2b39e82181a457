// What another site has, added to this one: two halls drawn apart, types and zones kept for many sites.
#pragma once

#include "exchange/preview.h"

namespace tessera::exchange {

/// text: a site file. Adds its tile types, tiles with their places, loose tags, zones, routes and vehicles. What goes
/// by a name, serial number, UID or address that `onto` has already stays as it is there; where the file says something
/// else of it, a note tells. Name, north, radio and picture of the file's site are not taken. All or nothing. Error:
/// the file is no site or contradicts itself; a tile is of a type that is another one here; a UID would stand at two
/// places; more of a kind than a site file holds. Names the file.
[[nodiscard]] Result<Preview> importSite(const floor::Site& onto, std::string_view text, const std::string& name);

}  // namespace tessera::exchange
