// What has to be told of the way from one site to another: a list for a person to read before saying yes to it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/box.h"
#include "base/sentence.h"
#include "floor/site.h"

namespace tessera::sitediff {

enum class ChangeKind : std::uint8_t { Added, Removed, Moved, Changed };
enum class Subject : std::uint8_t { Site, Radio, TileType, Tile, LooseTag, Zone, Route, Vehicle, Backdrop };

/// Stable, for scripts: "added", "tile-type".
[[nodiscard]] std::string_view codeOf(ChangeKind kind);
[[nodiscard]] std::string_view codeOf(Subject subject);

struct Change {
  ChangeKind kind = ChangeKind::Changed;
  Subject subject = Subject::Site;
  std::string name;  ///< serial number, UID, name; of a vehicle its address
  Sentence sentence;
  std::optional<Box> place;  ///< on the floor, where it has one
  bool operator==(const Change&) const = default;
};
using Changes = std::vector<Change>;

/// Items are the same that have the same serial number, UID, name or (vehicles) address; of several of one name the
/// first goes with the first. Empty when the sites are equal but for the order of their lists.
[[nodiscard]] Changes difference(const floor::Site& before, const floor::Site& after);

}  // namespace tessera::sitediff
