// Lines and polygons cut to what is in view, before the painter sees them: a leg a kilometre long at full zoom has
// coordinates and dashes that no painter stands.
#pragma once

#include <QLineF>
#include <QPolygonF>
#include <QRectF>
#include <optional>
#include <vector>

namespace tessera::ui {

/// The part of the line in the rectangle; nullopt: none (Liang and Barsky, 1984).
[[nodiscard]] std::optional<QLineF> clipped(const QLineF& line, const QRectF& to);
/// Sutherland and Hodgman, 1974. Empty: nothing in view.
[[nodiscard]] QPolygonF clipped(QPolygonF polygon, const QRectF& to);
/// The parts of a polyline whose steps come near the rectangle: what is left out lies wholly on one side of it.
[[nodiscard]] std::vector<QPolygonF> runsWithin(const QPolygonF& line, const QRectF& within);

}  // namespace tessera::ui
