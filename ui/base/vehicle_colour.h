// The colour by which a vehicle is told from the others, the same on the floor, in lists and in charts.
#pragma once

#include <QColor>
#include <QPalette>

#include "base/ids.h"
#include "floor/site.h"

namespace tessera::ui {

/// Of the vehicle at that place in the site's list; repeats after eight. Lighter where the palette is dark.
[[nodiscard]] QColor vehicleColour(int index, const QPalette& palette);
/// The same by its address; a vehicle that the site does not have is grey.
[[nodiscard]] QColor vehicleColour(const floor::Site& site, VehicleId id, const QPalette& palette);

}  // namespace tessera::ui
