// The program's own icons, drawn from resources/icons in the colour of the text around them, so that light and dark
// need no second set.
#pragma once

#include <QIcon>
#include <QString>

namespace tessera::ui {

/// The icon of resources/icons/NAME.svg, or a null icon when there is none. It follows changes of the palette.
[[nodiscard]] QIcon icon(const QString& name);

}  // namespace tessera::ui
