// Driving by hand with held keys: every Jog holds for kJogHolds, so that a vehicle stops soon after the key, the window
// or the operator is gone. Turns what the keys ask for into a command as a route's follower gives it.
#pragma once

#include <optional>

#include "drive/command.h"
#include "supervisor/order.h"

namespace tessera::supervisor {

class HandDrive {
public:
  explicit HandDrive(const drive::VehicleAbility& ability) : ability_{ability} {}

  /// False: it was barred, and the keys have not been let go since.
  bool take(const Jog& order, Seconds now);
  /// Something else has stopped the vehicle: a key that is still held must not move it again.
  void bar(Seconds now);
  /// The last Jog has not run out.
  [[nodiscard]] bool holds(Seconds now) const { return !barred_ && last_ && now < *last_ + kJogHolds; }
  /// nose: heading when the command takes effect; cycle: how long it holds until the next one comes.
  [[nodiscard]] drive::Command command(Radians nose, Seconds cycle);

private:
  drive::VehicleAbility ability_;
  MetresPerSecond speed_;
  RadiansPerSecond turnRate_;
  std::optional<Radians> straight_;  ///< the heading that is held while no turn is asked for
  std::optional<Seconds> last_;      ///< when the last Jog came, whether it was taken or not
  bool barred_ = false;
};

}  // namespace tessera::supervisor
