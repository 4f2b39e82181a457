// Draws how the site's vehicles round the corners of a route, where that leaves the line drawn by enough to be seen.
#pragma once

#include <QPainter>
#include <vector>

#include "floor/site.h"
#include "ui/canvas/theme.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

/// One arc for each corner and each corner cut among the vehicles; nothing for vehicles that turn on the spot.
void paintRoundWays(QPainter& painter, const View& view, const CanvasTheme& theme, const floor::Route& route,
                    const std::vector<floor::VehicleSetup>& vehicles);

}  // namespace tessera::ui
