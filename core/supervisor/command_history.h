// The drive commands that are in force on a vehicle or on their way to it, each with the span in which it holds: what
// the predictor needs to roll an estimate forward.
#pragma once

#include <span>
#include <vector>

#include "drive/command.h"

namespace tessera::supervisor {

class CommandHistory {
public:
  /// A Drive takes effect at `from`, takes over from the one before, and runs out after `expiry`.
  void drive(const drive::Command& command, Seconds from, Seconds expiry);
  /// A Stop or Clear takes effect at `from`: from then on none is in force.
  void stand(Seconds from);
  /// The vehicle has started anew: it knows no command.
  void clear() { commands_.clear(); }
  /// Sorted by `from`.
  [[nodiscard]] std::span<const drive::TimedCommand> commands() const { return commands_; }

private:
  void endAt(Seconds from);

  std::vector<drive::TimedCommand> commands_;
};

}  // namespace tessera::supervisor
