// Sites and snapshots for tests of what is drawn.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "floor/new_floor.h"
#include "floor/site_map.h"
#include "supervisor/snapshot.h"

namespace tessera::ui {

/// `columns` by `rows` tiles of 60 cm, one-in-two at 15 cm, from the origin; two routes and three vehicles.
inline floor::Site tiledSite(int columns, int rows) {
  floor::Site site;
  site.name = "Tiled";
  site.tileTypes = {floor::usualTileTypes()[0]};
  std::uint32_t count = 0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      floor::Tile tile{"T" + std::to_string(count), site.tileTypes.front().name, {}};
      for (std::uint8_t n = 0; n < 8; ++n) {
        const std::array<std::uint8_t, 7> uid{4,
                                              n,
                                              static_cast<std::uint8_t>(count >> 24U),
                                              static_cast<std::uint8_t>(count >> 16U),
                                              static_cast<std::uint8_t>(count >> 8U),
                                              static_cast<std::uint8_t>(count),
                                              1};
        tile.uids.push_back(floor::TagUid::fromBytes(uid).value());
      }
      site.placements.push_back({tile.serial, {Metres{0.6 * column}, Metres{0.6 * row}}, 0});
      site.tiles.push_back(std::move(tile));
      ++count;
    }
  }
  const auto point = [](double x, double y) { return Point{Metres{x}, Metres{y}}; };
  site.routes.push_back({"one", {point(0.5, 0.5), point(2.0, 0.5), point(2.0, 2.0)}, Metres{0.2}});
  site.routes.push_back({"two", {point(0.5, 1.4), point(1.5, 1.4)}, Metres{0.2}});
  for (std::uint8_t n = 1; n <= 3; ++n) {
    floor::VehicleSetup vehicle;
    vehicle.id = VehicleId{n};
    vehicle.name = "AGV " + std::to_string(n);
    vehicle.readers = {{Metres{0.15}, Metres{}}};
    vehicle.footprint = {point(-0.2, -0.15), point(0.2, -0.15), point(0.2, 0.15), point(-0.2, 0.15)};
    site.vehicles.push_back(vehicle);
  }
  return site;
}

inline std::shared_ptr<const floor::SiteMap> tiledMap(int columns, int rows) {
  return floor::SiteMap::build(tiledSite(columns, rows)).value();
}

/// Connected, located and standing.
inline supervisor::VehicleView vehicleAt(std::uint8_t id, double x, double y, double heading = 0.0) {
  supervisor::VehicleView v;
  v.id = VehicleId{id};
  v.name = "AGV " + std::to_string(id);
  v.contact = supervisor::Contact::Connected;
  v.located = true;
  v.pose = {{Metres{x}, Metres{y}}, Radians{heading}};
  v.predicted = v.pose;
  v.covariance = {1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 1e-3};
  v.link.lastHeard = Seconds{};
  return v;
}

inline std::shared_ptr<const supervisor::Snapshot> snapshotOf(double time,
                                                              std::vector<supervisor::VehicleView> vehicles) {
  auto snapshot = std::make_shared<supervisor::Snapshot>();
  snapshot->time = Seconds{time};
  snapshot->vehicles = std::move(vehicles);
  return snapshot;
}

}  // namespace tessera::ui
