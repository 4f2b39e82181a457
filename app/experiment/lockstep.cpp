#include "app/experiment/lockstep.h"

namespace tessera::experiment {
namespace {

// The world's own step; bytes reach the other side at most this much later than they would.
constexpr Seconds kStep{0.001};
constexpr const char* kPort = "in memory";

}  // namespace

Lockstep::Lockstep(sim::World& world, supervisor::Supervisor& supervisor, Recorder& recorder)
    : world_{world}, supervisor_{supervisor}, recorder_{recorder} {
  supervisor_.portOpened(kPort, now_);
}

bool Lockstep::run(Seconds limit, const std::function<bool()>& until) {
  while (now_ < limit) {
    now_ += kStep;
    world_.advance(now_);
    const auto bytes = world_.takeHostBytes();
    if (plugged_ && !bytes.empty()) supervisor_.ingest(bytes, now_);
    if (bytes.empty() && now_ < wake_) continue;
    tick();
    if (until()) return true;
  }
  return false;
}

void Lockstep::tick() {
  supervisor::TickOutput out = supervisor_.tick(now_);
  wake_ = out.wake;
  if (plugged_ && !out.bytes.empty()) world_.hostBytes(out.bytes);
  for (const auto& event : out.events) recorder_.take(event);
  if (out.snapshot) {
    recorder_.take(*out.snapshot);
    snapshot_ = std::move(out.snapshot);
  }
}

void Lockstep::pullPort() {
  plugged_ = false;
  supervisor_.portLost("the cable was pulled", now_);
}

void Lockstep::plugPort() {
  plugged_ = true;
  supervisor_.portOpened(kPort, now_);
}

}  // namespace tessera::experiment
