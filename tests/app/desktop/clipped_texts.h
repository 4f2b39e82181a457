// Looks at every widget of a window: is its text drawn whole?
#pragma once

#include <QStringList>
#include <QWidget>

namespace tessera::desktop {

/// "name of the widget “its text”" of each visible label, button, box, table heading and tab whose text is longer than
/// the place it has. What scrolls may be longer.
[[nodiscard]] QStringList clippedTexts(const QWidget& root);

}  // namespace tessera::desktop
