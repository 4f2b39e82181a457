// The page of a panel that has nothing to show yet: what to do next, and the button that begins it.
#pragma once

#include <QLabel>
#include <QPushButton>

namespace tessera::ui {

/// Both in the middle, the text wrapped; the page owns them.
[[nodiscard]] QWidget* emptyPage(QLabel* what, QPushButton* next);

}  // namespace tessera::ui
