// What the kinds of zones are called and what each means, in the window's language.
#pragma once

#include <QString>
#include <array>

#include "floor/site.h"

namespace tessera::ui {

inline constexpr std::array<floor::ZoneKind, 8> kZoneKinds{
    floor::ZoneKind::Running, floor::ZoneKind::Storage, floor::ZoneKind::Parking, floor::ZoneKind::Charging,
    floor::ZoneKind::NoGo,    floor::ZoneKind::Slow,    floor::ZoneKind::OneWay,  floor::ZoneKind::SingleVehicle};

/// "No-go zone".
[[nodiscard]] QString zoneKindName(floor::ZoneKind kind);
/// One sentence: what vehicles do there.
[[nodiscard]] QString zoneKindMeaning(floor::ZoneKind kind);
/// What holds where zones lie upon one another, a line for each rule.
[[nodiscard]] QString zoneStackingRules();

}  // namespace tessera::ui
