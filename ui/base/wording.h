// The core's sentences and words in the language of the window.
#pragma once

#include <QString>
#include <QStringList>

#include "base/sentence.h"
#include "supervisor/event.h"
#include "supervisor/snapshot.h"

namespace tessera::ui {

/// Its pattern translated, and whatever of its arguments can be. To be asked again when the language changes.
[[nodiscard]] QString text(const Sentence& sentence);

/// Short and capitalised, as in a table's cell or a badge: "Connected".
[[nodiscard]] QString text(supervisor::Contact contact);
[[nodiscard]] QString text(supervisor::Task task);
[[nodiscard]] QString text(supervisor::PortState state);
[[nodiscard]] QString text(supervisor::CommandStatus status);
[[nodiscard]] QString text(supervisor::Severity severity);
[[nodiscard]] QString text(wire::VehicleState state);
/// One for each bit set, in the order of the bits: "Motor stalled".
[[nodiscard]] QStringList faultTexts(std::uint16_t faults);

}  // namespace tessera::ui
