// What tools show beside the cursor while something is drawn or dragged: where it goes, how long and which way, what it
// has snapped to.
#pragma once

#include <QPainter>
#include <QStringList>

#include "ui/canvas/snapper.h"
#include "ui/canvas/theme.h"

namespace tessera::ui {

/// "1.20 m, 090°": how long the way is and where it leads, clockwise from north. northToY: see floor::Site.
[[nodiscard]] QString legText(Point from, Point to, Radians northToY);
[[nodiscard]] QString placeText(Point p);
/// What a place is, in a word; empty: nothing in particular.
[[nodiscard]] QString snapText(Snap::Kind kind);

/// A small panel beside the pixel, on its other side at the window's edge. Lines behind the first are quieter; what is
/// wrong stands below, broken into lines.
void paintReadout(QPainter& painter, const View& view, const CanvasTheme& theme, QPointF at, const QStringList& lines,
                  const QStringList& wrong = {});
/// The sign of what the place has snapped to.
void paintSnap(QPainter& painter, const View& view, const CanvasTheme& theme, const Snap& snap);
void paintHandle(QPainter& painter, QPointF at, double radius, QColor fill, QColor edge);

}  // namespace tessera::ui
