// A supervisor and a world in one process and one virtual time: the same firmware, frames, radio and supervisor as in
// a real run, but as fast as the machine allows and the same on every machine. Bytes between the two pass as they
// would through the port; nothing else does.
#pragma once

#include <functional>

#include "app/experiment/recorder.h"
#include "app/experiment/samples.h"
#include "sim/world.h"
#include "supervisor/supervisor.h"

namespace tessera::experiment {

class Lockstep {
public:
  /// Both must outlive this. Begins at time zero with the port open.
  Lockstep(sim::World& world, supervisor::Supervisor& supervisor, Recorder& recorder);

  /// Goes on until `until` says so (asked after every tick) or the time is `limit`. True: `until` said so.
  bool run(Seconds limit, const std::function<bool()>& until);
  [[nodiscard]] Seconds now() const { return now_; }
  [[nodiscard]] const std::shared_ptr<const supervisor::Snapshot>& snapshot() const { return snapshot_; }

  // The port, as an operator's hand would treat it.
  void pullPort();
  void plugPort();

private:
  void tick();

  sim::World& world_;
  supervisor::Supervisor& supervisor_;
  Recorder& recorder_;
  Seconds now_;
  Seconds wake_;
  bool plugged_ = true;
  std::shared_ptr<const supervisor::Snapshot> snapshot_;
};

}  // namespace tessera::experiment
