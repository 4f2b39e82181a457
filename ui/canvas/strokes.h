// Long smooth lines in short pieces. Qt's painter hands every fill of more than some hundred spans to a pool of threads
// and waits for them; for lines that costs many times what drawing them does, most of all on a busy machine.
#pragma once

#include <QLineF>
#include <QPainter>
#include <QPolygonF>

namespace tessera::ui {

/// With the painter's pen, which must be opaque and have square caps: the pieces overlap, and round ones cost much
/// more.
void strokeLine(QPainter& painter, const QLineF& line);
void strokePolyline(QPainter& painter, const QPolygonF& line);
/// Dashes of so many pixels with gaps half as long along the closed outline.
void strokeDashes(QPainter& painter, const QPolygonF& outline, double dash);

/// `share` (0 to 1) of `over` on `under`, opaque.
[[nodiscard]] QColor mixedColour(QColor under, QColor over, double share);

}  // namespace tessera::ui
