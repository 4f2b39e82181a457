// One turn of the supervisor's thread, without the thread: orders from the mailbox, a tick, results to the mailbox.
#pragma once

#include <optional>

#include "supervisor/mailbox.h"
#include "supervisor/supervisor.h"

namespace tessera::supervisor {

class Pump {
public:
  struct Turn {
    std::vector<std::uint8_t> bytes;  ///< for the port
    Seconds wake;                     ///< next turn at this instant at the latest
    bool newSnapshot = false;
    bool newEvents = false;
    bool closed = false;  ///< after close(): all vehicles stand, or the time for it is over
  };

  Pump(Supervisor supervisor, std::shared_ptr<Mailbox> mailbox)
      : supervisor_{std::move(supervisor)}, mailbox_{std::move(mailbox)} {}

  [[nodiscard]] Supervisor& supervisor() { return supervisor_; }
  /// Stops all vehicles; the turns say when they stand, or `deadline` has come. Orders are not taken any more.
  void close(Seconds deadline) {
    if (!deadline_) supervisor_.post(StopAll{});
    deadline_ = deadline;
  }
  [[nodiscard]] Turn turn(Seconds now) {
    while (auto order = mailbox_->nextOrder())
      if (!deadline_) supervisor_.post(std::move(*order));
    TickOutput out = supervisor_.tick(now);
    Turn turn{std::move(out.bytes), out.wake, false, !out.events.empty(), false};
    if (out.snapshot) turn.newSnapshot = mailbox_->publish(std::move(out.snapshot));
    for (Event& event : out.events) mailbox_->publish(std::move(event));
    turn.closed = deadline_ && (supervisor_.allStopped() || now >= *deadline_);
    return turn;
  }

private:
  Supervisor supervisor_;
  std::shared_ptr<Mailbox> mailbox_;
  std::optional<Seconds> deadline_;
};

}  // namespace tessera::supervisor
