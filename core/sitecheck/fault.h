// What is wrong with a site, in a form that a window can list, show on the floor and mend, and a script can count.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/box.h"
#include "base/sentence.h"
#include "sitecheck/fix.h"

namespace tessera::sitecheck {

enum class Severity : std::uint8_t {
  Warning,  ///< vehicles can be supervised, but somebody should look
  Error     ///< the site cannot be opened, or a vehicle would be led wrongly
};

// In the order of their codes in fault.cpp.
enum class FaultKind : std::uint8_t {
  TileTypeTwice,
  TileTwice,
  TileLaidTwice,
  TileUnknown,
  TileTypeUnknown,
  TooManyUids,
  PlaceNoNumber,
  UidTwice,
  TileUnregistered,
  TilePartlyRegistered,
  TilesOverlap,
  TileOffLattice,
  ZoneTwice,
  ZoneWithoutArea,
  ZoneCrossesItself,
  ZoneRepeatsPoint,
  ZoneWithoutSpeed,
  ZoneWithoutDirection,
  ZoneGap,
  ZonesContradict,
  ZoneUnreachable,
  RouteTwice,
  RouteTooShort,
  RouteRepeatsPoint,
  RouteLeavesRunningZone,
  RouteCrossesNoGo,
  RouteAgainstOneWay,
  RouteTooClose,
  RouteTooTight,
  RouteFasterThanZone,
  RouteWithoutTags,
  VehicleAddressTwice,
  VehicleAddressInvalid,
  VehicleTwice,
  VehicleWithoutKey,
  VehicleKeyShared,
  VehicleWithoutReaders,
  VehicleWithoutFootprint,
  VehicleStartOutside,
  RadioSettingInvalid,
  RadioTooSlow,
  NoTags,
  NoVehicle,
  NoRunningZone
};
inline constexpr std::size_t kFaultKinds = static_cast<std::size_t>(FaultKind::NoRunningZone) + 1;

/// Stable, for scripts: "tiles-overlap".
[[nodiscard]] std::string_view codeOf(FaultKind kind);
[[nodiscard]] std::string_view codeOf(Severity severity);

enum class ObjectKind : std::uint8_t { TileType, Tile, Tag, Zone, Route, Vehicle };
/// "tile", for scripts.
[[nodiscard]] std::string_view codeOf(ObjectKind kind);

/// A thing of the site by the name that it goes by there: serial number, UID, name.
struct Object {
  ObjectKind kind = ObjectKind::Tile;
  std::string name;
  bool operator==(const Object&) const = default;
};

struct Fault {
  FaultKind kind = FaultKind::NoTags;
  Severity severity = Severity::Warning;
  Sentence sentence = {};
  std::optional<Box> place = {};     ///< what to show; none: it has no place
  std::vector<Object> objects = {};  ///< the one to blame first
  std::optional<Fix> fix = {};       ///< where there is an obvious one
  std::size_t stands = 1;            ///< for how many: more where one sentence tells of those that are not listed
  bool operator==(const Fault&) const = default;
};
using Faults = std::vector<Fault>;

}  // namespace tessera::sitecheck
