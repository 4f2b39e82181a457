// What the tool and the panel ask of a zone's outline.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "floor/site.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

/// Of the floor that the outline encloses; where it crosses itself, what is inside an odd number of times.
[[nodiscard]] double squareMetres(std::span<const Point> outline);
/// "1.44 m²"
[[nodiscard]] QString areaText(double squareMetres);
/// Corners from the lower left one on, counter-clockwise. Equal x or y: no area.
[[nodiscard]] std::vector<Point> rectangle(Point a, Point b);
/// All corners moved alike.
[[nodiscard]] std::vector<Point> moved(std::span<const Point> outline, Offset by);

/// The zones under the pixel, the smallest first: it lies on top of what holds it.
[[nodiscard]] std::vector<std::size_t> zonesAt(const std::vector<floor::Zone>& zones, const View& view, QPointF pixel);
/// The corner from which the nearest edge within reach begins.
[[nodiscard]] std::optional<std::size_t> edgeAt(std::span<const Point> outline, const View& view, QPointF pixel,
                                                double reach);

}  // namespace tessera::ui
