// Draws a route: line, direction, vertices, name; the chosen one stronger, with its control points when near enough.
#pragma once

#include <QPainter>
#include <vector>

#include "floor/site.h"
#include "ui/canvas/theme.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

enum class RouteLook { Quiet, Chosen };

void paintRoute(QPainter& painter, const View& view, const CanvasTheme& theme, const floor::Route& route,
                RouteLook look);

/// Distance in pixels from the nearest leg; infinite without one.
[[nodiscard]] double pixelsFromRoute(const View& view, const std::vector<Point>& vertices, QPointF pixel);

}  // namespace tessera::ui
