// Which orders make sense for a vehicle now, and in words why one does not. Buttons, menus and tooltips ask here.
#pragma once

#include <QString>
#include <optional>

#include "supervisor/snapshot.h"

namespace tessera::ui {

/// What is to be ordered and of whom.
struct OrderCase {
  const supervisor::Snapshot* snapshot = nullptr;  ///< null: no supervision runs
  std::optional<VehicleId> vehicle;                ///< nobody chosen
  QString name;                                    ///< of the vehicle
  QString route;                                   ///< chosen; empty: none
  bool siteHasRoutes = false;
  bool sameAsRunning = false;  ///< the vehicle runs this very route at this very speed already
};

/// Each gives a sentence that says why the order would make no sense; empty: it can be given.
[[nodiscard]] QString whyNotRun(const OrderCase& c);
[[nodiscard]] QString whyNotPause(const OrderCase& c);
[[nodiscard]] QString whyNotResume(const OrderCase& c);
/// Stopping is forbidden least: whenever there is somebody to tell it to.
[[nodiscard]] QString whyNotStop(const OrderCase& c);
[[nodiscard]] QString whyNotClear(const OrderCase& c);

}  // namespace tessera::ui
