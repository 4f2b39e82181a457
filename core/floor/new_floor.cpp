#include "floor/new_floor.h"

#include <array>
#include <vector>

#include "floor/serial_rule.h"

namespace tessera::floor {
namespace {

TileType square(const char* name, double side, double pitch, Pattern pattern) {
  const int places = static_cast<int>(side / pitch + 0.5);
  const Metres half{pitch / 2};
  return {name, Metres{side}, Metres{side}, Metres{pitch}, {half, half}, places, places, pattern, false, {}};
}

// Seven bytes behind a maker's code that no maker has: nobody takes them for a real tag's.
TagUid practiceUid(std::uint64_t number) {
  std::array<std::uint8_t, 7> bytes{0xF0};
  for (std::size_t i = 6; i > 0; --i, number >>= 8) bytes[i] = static_cast<std::uint8_t>(number);
  return TagUid::fromBytes(bytes).value();
}

// As the demo sites have it; the key is known to everybody.
VehicleSetup practiceVehicle(Point middle) {
  VehicleSetup v = usualVehicle();
  v.id = VehicleId{1};
  v.name = "AGV 1";
  v.key.fill(0xF0);
  v.start = Pose{middle, Radians{}};
  return v;
}

}  // namespace

std::span<const TileType> usualTileTypes() {
  static const std::array<TileType, 8> types{
      square("60x60 one-in-two 15", 0.60, 0.15, Pattern::OneInTwo), square("60x60 full 15", 0.60, 0.15, Pattern::Full),
      square("60x60 one-in-two 10", 0.60, 0.10, Pattern::OneInTwo), square("60x60 full 20", 0.60, 0.20, Pattern::Full),
      square("45x45 one-in-two 15", 0.45, 0.15, Pattern::OneInTwo), square("45x45 full 15", 0.45, 0.15, Pattern::Full),
      square("30x30 one-in-two 10", 0.30, 0.10, Pattern::OneInTwo), square("30x30 full 15", 0.30, 0.15, Pattern::Full)};
  return types;
}

VehicleSetup usualVehicle() {
  VehicleSetup v;
  v.readers = {{Metres{0.15}, Metres{0.1}}, {Metres{0.15}, Metres{}}, {Metres{0.15}, Metres{-0.1}}};
  const auto corner = [](double x, double y) { return Point{Metres{x}, Metres{y}}; };
  v.footprint = {corner(-0.2, -0.18), corner(0.2, -0.18), corner(0.2, 0.18), corner(-0.2, 0.18)};
  return v;
}

Result<Site> layNewFloor(const NewFloor& wish) {
  const bool empty = wish.columns == 0 && wish.rows == 0;
  for (const int count : {wish.columns, wish.rows}) {
    if (empty) break;
    if (count < 1 || count > NewFloor::kMost)
      return failure(
          phrase("Core", "A floor has 1 to %1 tiles along each side, not %2.").with(int{NewFloor::kMost}, count));
  }
  const std::size_t tags = tagOffsets(wish.type).size();
  if (tags == 0) return failure(phrase("Core", "The tile type %1 has no tags.").with(wish.type.name));
  Site site;
  site.name = wish.name;
  site.tileTypes = {wish.type};
  std::uint64_t next = 1;
  for (int row = 0; row < wish.rows; ++row) {
    for (int column = 0; column < wish.columns; ++column) {
      Tile tile{serialOf({}, row * wish.columns + column + 1), wish.type.name, {}};
      for (std::size_t i = 0; wish.practice && i < tags; ++i) tile.uids.push_back(practiceUid(next++));
      site.placements.push_back({tile.serial, {column * wish.type.width, row * wish.type.height}, 0});
      site.tiles.push_back(std::move(tile));
    }
  }
  if (empty) return site;
  const Metres right = wish.columns * wish.type.width;
  const Metres top = wish.rows * wish.type.height;
  site.zones = {{"Floor", ZoneKind::Running, {{}, {right, {}}, {right, top}, {{}, top}}, {}, {}}};
  if (wish.practice) site.vehicles = {practiceVehicle({right / 2.0, top / 2.0})};
  return site;
}

}  // namespace tessera::floor
