// The publication's floor, built in code: 3 × 3 tiles of 60 cm, tags one-in-two at 15 cm pitch, and its vehicle.
#pragma once

#include <memory>

#include "floor/site_map.h"

namespace tessera::test {

[[nodiscard]] inline floor::TagUid uidOf(int tile, int index) {
  const std::array<std::uint8_t, 4> bytes{0x04, 0x5A, static_cast<std::uint8_t>(tile),
                                          static_cast<std::uint8_t>(index)};
  return *floor::TagUid::fromBytes(bytes);
}

[[nodiscard]] inline floor::Site paperSite() {
  floor::Site site;
  site.name = "paper";
  floor::TileType type;
  type.name = "60";
  type.width = type.height = Metres{0.60};
  type.pitch = Metres{0.15};
  type.margin = {Metres{0.075}, Metres{0.075}};
  type.columns = type.rows = 4;
  site.tileTypes.push_back(type);
  const std::size_t tags = tagOffsets(type).size();
  for (int n = 0; n < 9; ++n) {
    floor::Tile tile{"T" + std::to_string(n), type.name, {}};
    for (std::size_t i = 0; i < tags; ++i) tile.uids.push_back(uidOf(n, static_cast<int>(i)));
    site.tiles.push_back(tile);
    site.placements.push_back({tile.serial, {Metres{0.6 * (n % 3)}, Metres{0.6 * (n / 3)}}, 0});
  }
  floor::Route route;
  route.name = "paper";
  for (const auto& [x, y] : {std::pair{30, 30}, {30, 150}, {90, 150}, {90, 30}, {150, 30}, {150, 150}})
    route.vertices.push_back({Metres{x / 100.0}, Metres{y / 100.0}});
  site.routes.push_back(route);
  return site;
}

[[nodiscard]] inline floor::VehicleSetup paperVehicle(int readers = 3) {
  floor::VehicleSetup vehicle;
  vehicle.id = VehicleId{1};
  vehicle.name = "one";
  for (int i = 0; i < readers; ++i) vehicle.readers.push_back({Metres{0.15}, Metres{0.10 * (0.5 * (readers - 1) - i)}});
  return vehicle;
}

[[nodiscard]] inline std::shared_ptr<const floor::SiteMap> paperMap() {
  return floor::SiteMap::build(paperSite()).value();
}

}  // namespace tessera::test
