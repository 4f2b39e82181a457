// What both panels of the calibration are made of.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <optional>

#include "ui/base/site_document.h"

namespace tessera::ui {

/// A label for sentences, which wraps; children of `parent`, found by `name`.
[[nodiscard]] QLabel* sentenceLabel(QWidget* parent, const char* name);
/// `picture`: an icon's name.
[[nodiscard]] QPushButton* orderButton(QWidget* parent, const char* name, const char* picture);
/// Empty: none is chosen, or the site has it no more.
[[nodiscard]] QString nameOf(const SiteDocument& document, std::optional<VehicleId> vehicle);

}  // namespace tessera::ui
