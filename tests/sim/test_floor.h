// A piece of tile floor for tests: one square tile, tags one-in-two at a pitch of 15 cm.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "floor/site_map.h"

namespace tessera::sim {

inline floor::TagUid uidOfNumber(std::uint32_t n) {
  const std::array<std::uint8_t, 4> bytes{static_cast<std::uint8_t>(0x10U | (n >> 24U)),
                                          static_cast<std::uint8_t>(n >> 16U), static_cast<std::uint8_t>(n >> 8U),
                                          static_cast<std::uint8_t>(n)};
  return floor::TagUid::fromBytes(bytes).value();
}

/// `places` lattice places each way, from the site's origin.
inline floor::Site testSite(int places) {
  floor::Site site;
  site.name = "test floor";
  floor::TileType type;
  type.name = "t";
  type.pitch = Metres{0.15};
  type.width = type.height = places * type.pitch;
  type.margin = {Metres{0.075}, Metres{0.075}};
  type.columns = type.rows = places;
  floor::Tile tile{"s1", "t", {}};
  const std::size_t tags = tagOffsets(type).size();
  for (std::uint32_t i = 0; i < tags; ++i) tile.uids.push_back(uidOfNumber(i + 1));
  site.tileTypes = {type};
  site.tiles = {tile};
  site.placements = {{"s1", {}, 0}};
  return site;
}

inline floor::VehicleSetup testVehicle() {
  floor::VehicleSetup setup;
  setup.id = VehicleId{7};
  setup.name = "test vehicle";
  for (std::size_t i = 0; i < setup.key.size(); ++i) setup.key[i] = static_cast<std::uint8_t>(0xA0 + i);
  setup.readers = {{Metres{0.15}, Metres{0.10}}, {Metres{0.15}, Metres{0.0}}, {Metres{0.15}, Metres{-0.10}}};
  return setup;
}

}  // namespace tessera::sim
