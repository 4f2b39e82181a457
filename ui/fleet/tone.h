// How good or bad something is, as a colour: icons and words of the fleet's panels take it from here, so that the same
// red means the same everywhere, in light and dark.
#pragma once

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QString>

namespace tessera::ui {

enum class Tone { Plain, Quiet, Good, Busy, Warning, Bad };

/// Readable as text on the palette's Base and Window.
[[nodiscard]] QColor toneColour(Tone tone, const QPalette& palette);

/// The icon of that name in one colour, whatever mode it is drawn in. Kept, as drawing it anew costs a hundred times
/// more.
[[nodiscard]] QIcon tintedIcon(const QString& name, const QColor& colour, int side, qreal pixelRatio);
/// A filled disc, the sign of a vehicle, with a rim that keeps it from sinking into a ground of its own colour.
[[nodiscard]] QIcon dotIcon(const QColor& colour, const QColor& rim, int side, qreal pixelRatio);

}  // namespace tessera::ui
