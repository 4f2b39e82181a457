// Finds places of a site by what somebody types: a tile's serial number, a tag's UID, a name, coordinates.
#pragma once

#include <QString>
#include <vector>

#include "floor/site_map.h"
#include "ui/canvas/site_box.h"

namespace tessera::ui {

/// So much of what is around it is shown with a place that was found.
inline constexpr Metres kAroundFound{0.5};

struct FoundPlace {
  enum class Kind { Coordinates, Tag, Tile, Zone, Route, Vehicle };
  Kind kind = Kind::Tile;
  QString name;
  SiteBox box;  ///< grown by kAroundFound
};

/// At most `most`, the best first: coordinates ("1.2 3.4" or "1.2; 3.4" in metres), then what is called so, what begins
/// so, what has it within. Upper and lower case are the same. UIDs count from their beginning, from four digits on.
/// Tiles that are not laid, and vehicles without a known place, are not found.
[[nodiscard]] std::vector<FoundPlace> findPlaces(const floor::SiteMap& map, const QString& text, std::size_t most = 30);

}  // namespace tessera::ui
