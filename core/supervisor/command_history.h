// The drive commands that are in force on a vehicle or on their way to it: what the predictor needs to roll an estimate
// forward. The radio repeats nothing, so each may be lost. An answer says that its command was taken; where none came,
// the command or the answer was lost, and one is as likely as the other.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "drive/command.h"

namespace tessera::supervisor {

class CommandHistory {
public:
  /// What may be in force, and how likely that is.
  struct Case {
    double chance = 1.0;
    std::vector<drive::TimedCommand> commands;  ///< sorted by `from`
  };

  /// A Drive that went under this counter takes effect at `from`, takes over from the one before, and runs out after
  /// `expiry`.
  void drive(const drive::Command& command, Seconds from, Seconds expiry, std::uint32_t counter);
  /// A Stop or Clear takes effect at `from`: from then on none is in force.
  void stand(Seconds from, std::uint32_t counter);
  /// It was acknowledged.
  void taken(std::uint32_t counter);
  /// No answer to it came in time.
  void unanswered(std::uint32_t counter);
  /// The vehicle has started anew: it knows no command.
  void clear() { entries_.clear(); }
  /// Chances add up to 1; the first case is that nothing was lost. One alone where no loss would change anything; eight
  /// at most.
  [[nodiscard]] std::vector<Case> cases() const;
  /// Something may be in force after `at`.
  [[nodiscard]] bool holdsAfter(Seconds at) const;

private:
  enum class Fate : std::uint8_t { UnderWay, Unanswered, Taken };
  struct Entry {
    std::optional<drive::Command> command;  ///< none: stand
    Seconds from;
    Seconds until;
    std::uint32_t counter = 0;
    Fate fate = Fate::UnderWay;
  };

  void put(Entry entry);
  [[nodiscard]] std::vector<std::size_t> open() const;
  [[nodiscard]] double chanceOfLoss(const Entry& entry) const;

  std::vector<Entry> entries_;  ///< sorted by `from`
  double unanswered_ = 0.04;    ///< share of the last commands; a packet in fifty is lost where nothing else is known
};

}  // namespace tessera::supervisor
