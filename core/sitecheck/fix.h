// An edit that mends a fault, described: the window names it, asks, and applies it as one step.
#pragma once

#include <variant>

#include "base/sentence.h"
#include "floor/site.h"

namespace tessera::sitecheck {

// Each names what it changes by name and by the value it had: an edit that was found for another state of the site does
// nothing.

struct MoveTile {
  floor::Placement before;
  Point origin;
  bool operator==(const MoveTile&) const = default;
};
/// The tile is not laid there any more; it stays known.
struct TakeTileUp {
  floor::Placement placement;
  bool operator==(const TakeTileUp&) const = default;
};
/// The second entry of a tile that is listed twice, both alike.
struct ForgetTile {
  floor::Tile tile;
  bool operator==(const ForgetTile&) const = default;
};
/// The second of two tiles of one serial number gets another. The first is laid where that serial number is.
struct RenameTile {
  floor::Tile tile;
  std::string serial;
  bool operator==(const RenameTile&) const = default;
};
/// UIDs beyond the tags that the tile's type has.
struct DropUids {
  floor::Tile tile;
  std::size_t keep = 0;
  bool operator==(const DropUids&) const = default;
};
/// The second entry of a tile type that is listed twice, both alike.
struct ForgetTileType {
  floor::TileType type;
  bool operator==(const ForgetTileType&) const = default;
};
struct ClearUid {
  std::string serial;
  std::size_t position = 0;  ///< in the tile's UIDs, from 0
  floor::TagUid uid;
  bool operator==(const ClearUid&) const = default;
};
struct ForgetLooseTag {
  floor::LooseTag tag;
  bool operator==(const ForgetLooseTag&) const = default;
};
struct ReplaceOutline {
  std::string zone;
  std::vector<Point> before;
  std::vector<Point> after;
  bool operator==(const ReplaceOutline&) const = default;
};
struct ReplaceVertices {
  std::string route;
  std::vector<Point> before;
  std::vector<Point> after;  ///< some of those, in their order
  bool operator==(const ReplaceVertices&) const = default;
};
struct SetLegSpeed {
  std::string route;
  std::size_t leg = 0;  ///< from 0
  std::optional<MetresPerSecond> before;
  std::optional<MetresPerSecond> after;
  bool operator==(const SetLegSpeed&) const = default;
};
/// Of all legs at once, as where a bend lies between two.
struct SetLegSpeeds {
  floor::Route before;
  std::vector<std::optional<MetresPerSecond>> after;
  bool operator==(const SetLegSpeeds&) const = default;
};
/// As many as there were: each leg keeps its speed.
struct MoveVertices {
  std::string route;
  std::vector<Point> before;
  std::vector<Point> after;
  bool operator==(const MoveVertices&) const = default;
};
struct ReverseRoute {
  floor::Route before;
  bool operator==(const ReverseRoute&) const = default;
};
struct GiveAddress {
  floor::VehicleSetup vehicle;  ///< as it is
  VehicleId id;
  bool operator==(const GiveAddress&) const = default;
};

using Edit =
    std::variant<MoveTile, TakeTileUp, ForgetTile, RenameTile, DropUids, ForgetTileType, ClearUid, ForgetLooseTag,
                 ReplaceOutline, ReplaceVertices, SetLegSpeed, SetLegSpeeds, MoveVertices, ReverseRoute, GiveAddress>;

struct Fix {
  Sentence sentence;  ///< an order: "Move tile "T-1" to (0.6, 1.2) m"
  Edit edit;
  bool operator==(const Fix&) const = default;
};

/// False: the site is no longer as it was when the edit was found; nothing has changed then.
[[nodiscard]] bool mend(const Edit& edit, floor::Site& site);

}  // namespace tessera::sitecheck
