// Light or dark: the palette of the whole program.
#pragma once

#include <QPalette>
#include <QString>

namespace tessera::desktop {

enum class Appearance { System, Light, Dark };

[[nodiscard]] QPalette paletteFor(Appearance appearance);
/// Sets style and palette of the QApplication. System follows the desktop's own palette as it was at the start.
void apply(Appearance appearance);

/// "system", "light", "dark"; an unknown word counts as system.
[[nodiscard]] QString nameOf(Appearance appearance);
[[nodiscard]] Appearance appearanceOf(const QString& name);

}  // namespace tessera::desktop
