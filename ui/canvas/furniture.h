// What helps to read the map and is no part of the floor: grid with its numbers, scale bar, north arrow.
#pragma once

#include <QPainter>
#include <QString>

#include "ui/canvas/theme.h"
#include "ui/canvas/view.h"

namespace tessera::ui {

/// The smallest of 1, 2, 5 times a power of ten metres that is at least so many pixels long.
[[nodiscard]] Metres niceLength(double pixelsPerMetre, double leastPixels);
/// "0.5" with as many decimals as the step needs, in the language's way of writing numbers.
[[nodiscard]] QString stepText(Metres at, Metres step);
/// A length with its unit: "20 cm", "5 m", "1 km".
[[nodiscard]] QString lengthText(Metres length);

/// Lines of the grid; `onFloor` draws the fainter ones that lie over the tiles.
void paintGrid(QPainter& painter, const View& view, const CanvasTheme& theme, bool onFloor);
/// Numbers of the grid in bands along the left and the lower edge.
void paintRulers(QPainter& painter, const View& view, const CanvasTheme& theme);
/// Width of the left band, height of the lower one.
[[nodiscard]] QSizeF rulerBand(const QFont& font);
void paintScaleBar(QPainter& painter, const View& view, const CanvasTheme& theme);
/// northToY: see floor::Site.
void paintNorthArrow(QPainter& painter, const View& view, const CanvasTheme& theme, Radians northToY);
/// Text with a halo, so that it can be read on anything. `at` is the base line's left end.
void paintHaloText(QPainter& painter, QPointF at, const QString& text, QColor colour, QColor halo);

}  // namespace tessera::ui
