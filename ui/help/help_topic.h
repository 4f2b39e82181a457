// Which help page belongs to a widget: views name theirs by the dynamic property "helpTopic", and what lies in them
// belongs to the same page.
#pragma once

#include <QString>

class QWidget;

namespace tessera::ui {

/// Of the widget or the nearest of its parents that names one; "start" when none does, or for nullptr.
[[nodiscard]] QString helpTopicOf(const QWidget* widget);

}  // namespace tessera::ui
