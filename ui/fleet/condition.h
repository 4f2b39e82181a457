// How a vehicle stands, in one or two words: what an operator asks first. Derived from contact, task and report.
#pragma once

#include <QString>

#include "supervisor/snapshot.h"
#include "ui/fleet/tone.h"

namespace tessera::ui {

/// From the worst to the best; lists are sorted by it.
enum class Condition {
  Faulted,
  Refused,
  Silent,
  Obstacle,  ///< stands before one, with no route to run
  Waiting,   ///< should run, but stands: VehicleView::waits says why
  NoPort,    ///< no supervision, or its port is not open
  Calling,
  Calibrating,
  Paused,
  Running,
  ByHand,  ///< driven by keys
  Stopped,
  Ready,
  Finished,
};

/// `snapshot` may be null, and the vehicle unknown to it.
[[nodiscard]] Condition conditionOf(const supervisor::Snapshot* snapshot, const supervisor::VehicleView* vehicle);

[[nodiscard]] QString words(Condition condition);
[[nodiscard]] QString iconName(Condition condition);
[[nodiscard]] Tone toneOf(Condition condition);

/// What the operator should know or do now, one or two sentences: why it waits, what it does, or what comes next.
[[nodiscard]] QString situation(const supervisor::Snapshot* snapshot, const supervisor::VehicleView* vehicle,
                                const QString& name);

/// Half the width of the place's uncertainty at 95 %, in the worst direction.
[[nodiscard]] Metres placeUncertainty(const supervisor::VehicleView& vehicle);

}  // namespace tessera::ui
