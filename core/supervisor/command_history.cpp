#include "supervisor/command_history.h"

#include <algorithm>

#include "locate/locator.h"

namespace tessera::supervisor {

void CommandHistory::drive(const drive::Command& command, Seconds from, Seconds expiry) {
  endAt(from);
  commands_.push_back({command, from, from + expiry});
}

void CommandHistory::stand(Seconds from) { endAt(from); }

void CommandHistory::endAt(Seconds from) {
  // The instants are estimates and may cross when the measured latency changes: the later command still wins.
  while (!commands_.empty() && commands_.back().from >= from) commands_.pop_back();
  if (!commands_.empty()) commands_.back().until = std::min(commands_.back().until, from);
  const auto old = [&](const drive::TimedCommand& c) { return c.until < from - locate::Locator::kHistory; };
  commands_.erase(commands_.begin(), std::find_if_not(commands_.begin(), commands_.end(), old));
}

}  // namespace tessera::supervisor
