// Routes and stations as a file of the VDMA's Layout Interchange Format 1.0, for fleet managers of other makers:
// routes are its nodes and edges, parking, charging and storage zones its stations.
#pragma once

#include "exchange/preview.h"

namespace tessera::exchange {

struct LifText {
  std::string text;
  std::vector<Sentence> leftOut;  ///< what of the site the format cannot carry
};

/// timestamp: of the export, ISO 8601 in UTC: "2017-04-15T11:40:03Z". Coordinates in metres; edges are named ROUTE/1,
/// ROUTE/2 and so on, by which an import finds the routes again.
[[nodiscard]] LifText writeLif(const floor::Site& site, const std::string& timestamp);

/// Routes replace those of their names or come new; stations become zones where the site has none of that name. Edges
/// that no name joins are joined where only one leads on. Error: names the file and the JSON pointer.
[[nodiscard]] Result<Preview> importLif(const floor::Site& onto, std::string_view text, const std::string& name);

/// Side of the square zone that a station becomes: a station is a point, a zone is not.
inline constexpr Metres kStationSide{0.6};

}  // namespace tessera::exchange
