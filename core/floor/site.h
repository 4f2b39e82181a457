// A site as its integrator describes it: plain values, as they stand in a *.tessera.json file.
// Lengths in metres, angles in radians; the site frame has x and y as drawn, headings counter-clockwise from x.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/ids.h"
#include "base/pose.h"
#include "floor/tag.h"
#include "wire/security.h"

namespace tessera::floor {

enum class Pattern { Full, OneInTwo, Custom };

/// Size, pitch and pattern that many tiles share. The lattice's places run row by row from the lower left corner.
struct TileType {
  std::string name;
  Metres width;
  Metres height;
  Metres pitch;
  Offset margin;  ///< from the tile's lower left corner to the lattice's first place (half a pitch by default)
  int columns = 0;
  int rows = 0;
  Pattern pattern = Pattern::OneInTwo;
  bool startsWithGap = false;  ///< one-in-two only: the first place is empty
  std::vector<bool> custom;    ///< Custom only: columns * rows places, true = a tag
  bool operator==(const TileType&) const = default;
};

/// Places of the type's tags from the tile's lower left corner, in the order of a tile's UIDs.
[[nodiscard]] std::vector<Offset> tagOffsets(const TileType& type);

/// One floor slab. uids[n] is the tag at tagOffsets(type)[n]; an empty one is not registered (or dead).
struct Tile {
  std::string serial;
  std::string type;
  std::vector<TagUid> uids;
  bool operator==(const Tile&) const = default;
};

/// Where a tile lies: its lower left corner before turning is at `origin` after turning about it is undone, i.e. a tag
/// at offset l lies at origin + R(turn) * l, the formula of the publication with the turn added.
struct Placement {
  std::string serial;
  Point origin;
  int quarterTurns = 0;  ///< 0 to 3, counter-clockwise
  bool operator==(const Placement&) const = default;
};

/// A registered tag that belongs to no tile.
struct LooseTag {
  TagUid uid;
  Point place;
  bool operator==(const LooseTag&) const = default;
};

enum class ZoneKind { Running, Storage, Parking, Charging, NoGo, Slow, OneWay, SingleVehicle };

struct Zone {
  std::string name;
  ZoneKind kind = ZoneKind::Running;
  std::vector<Point> outline;
  std::optional<MetresPerSecond> speed;  ///< Slow
  std::optional<Radians> direction;      ///< OneWay
  bool operator==(const Zone&) const = default;
};

struct Route {
  std::string name;
  std::vector<Point> vertices;
  Metres controlSpacing{0.20};  ///< d, distance of control points
  /// Speed limit of leg n, from vertex n to vertex n + 1. Empty: no leg has one; else as many as there are legs.
  std::vector<std::optional<MetresPerSecond>> legSpeeds = {};
  bool operator==(const Route&) const = default;
};

/// What VehicleSetup::cornerCut may be at most.
inline constexpr Metres kMostCornerCut{0.5};

/// A vehicle as it was set up. Offsets are in vehicle axes (x forward, y left) from the middle between driven wheels.
struct VehicleSetup {
  VehicleId id;
  std::string name;
  wire::Key key{};
  std::vector<Offset> readers;   ///< from the vehicle's left to its right, in the order of reader numbers
  Metres readerRadius{0.06};     ///< radius of the disc in which a reader sees a tag
  std::vector<Point> footprint;  ///< outline in vehicle axes
  Metres track{0.30};            ///< between the driven wheels
  Metres wheelDiameter{0.10};
  MetresPerSecond maxSpeed{0.5};
  RadiansPerSecond maxTurnRate{1.5};
  MetresPerSecond2 acceleration{0.5};
  /// By how much it may leave a route's vertex to round its corner. 0: it drives to the vertex and turns on the spot.
  Metres cornerCut{0.0};
  std::optional<Pose> start;  ///< where it stands when nobody has located it yet
  bool operator==(const VehicleSetup&) const = default;
};

/// The radio channel that the site's vehicles share.
struct RadioSetup {
  int channel = 23;        ///< E32: 410 + channel MHz, 0 to 31
  double airRate = 19200;  ///< bit/s: 300, 1200, 2400, 4800, 9600, 19200
  int baud = 115200;       ///< of the UART between host and module
  bool operator==(const RadioSetup&) const = default;
};

/// A drawing of the building to lay tiles upon. It is shown only: nothing is decided by it.
struct Backdrop {
  std::string file;                            ///< name of the file it came from, for people
  std::shared_ptr<const std::string> picture;  ///< that file's bytes, PNG or JPEG; shared, as sites are copied often
  Point origin;                                ///< of the picture's lower left corner
  Metres pixel{0.01};                          ///< length of a pixel's side
  Radians turn;                                ///< about `origin`, counter-clockwise
  double opacity = 0.5;                        ///< 0 to 1
  bool operator==(const Backdrop& other) const {
    const bool same = picture == other.picture || (picture && other.picture && *picture == *other.picture);
    return same && file == other.file && origin == other.origin && pixel == other.pixel && turn == other.turn &&
           opacity == other.opacity;
  }
};

struct Site {
  std::string name;
  /// Clockwise angle from north to the site's y axis: a vehicle that faces along +y has this bearing.
  Radians northToY;
  RadioSetup radio;
  std::vector<TileType> tileTypes;
  std::vector<Tile> tiles;
  std::vector<Placement> placements;
  std::vector<LooseTag> looseTags;
  std::vector<Zone> zones;
  std::vector<Route> routes;
  std::vector<VehicleSetup> vehicles;
  std::optional<Backdrop> backdrop = {};
  bool operator==(const Site&) const = default;
};

}  // namespace tessera::floor
