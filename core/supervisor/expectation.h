// Where a vehicle is expected to be by now, or by the time a command reaches it, when it is not known which of the
// commands on the air it has got: the mean over the cases, and how far they lie apart.
#pragma once

#include <Eigen/Core>
#include <span>

#include "drive/predictor.h"
#include "locate/locator.h"
#include "supervisor/command_history.h"

namespace tessera::supervisor {

struct Expectation {
  drive::VehicleState state;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();  ///< m², of the places of the cases
};

/// `known` rolled forward to `until`. Requires a case.
[[nodiscard]] Expectation expectedOver(const drive::VehicleState& known, std::span<const CommandHistory::Case> cases,
                                       Seconds until, const drive::VehicleAbility& ability);

/// Covariance of x, y and heading after a further way: one driven with a heading that is not quite known leads aside by
/// as much, and with a scale, too far or not far enough.
[[nodiscard]] Eigen::Matrix3d rolledOn(const locate::Estimate& from, Offset way);

}  // namespace tessera::supervisor
