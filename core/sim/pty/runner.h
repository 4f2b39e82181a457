// Runs a world in real time behind a pseudo terminal: a loop over poll(), one thread, CLOCK_MONOTONIC.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/pty/pty.h"
#include "sim/world.h"

namespace tessera::sim {

/// Seconds of CLOCK_MONOTONIC: the clock that worlds and supervisors share in real runs.
[[nodiscard]] Seconds monotonicNow();

class RealTimeRunner {
public:
  /// At most this much is made up for at one go; what is older than kGiveUp is skipped and told.
  static constexpr Seconds kAtOnce{0.1};
  static constexpr Seconds kGiveUp{0.5};

  /// The world's clock must have been started with monotonicNow(). The world must outlive the runner.
  explicit RealTimeRunner(World& world) : world_{world} {}

  /// The port that the supervisor opens; nullopt: pulled out.
  void setPort(std::optional<Pty> port) { port_ = std::move(port); }
  [[nodiscard]] const std::optional<Pty>& port() const { return port_; }
  /// Calls `readable` in the loop whenever fd has something to read or was closed at its other end.
  void watch(int fd, std::function<void()> readable);
  void unwatch(int fd);
  /// Calls `trouble` with a sentence whenever something goes wrong that the run survives.
  void onTrouble(std::function<void(const std::string&)> trouble) { trouble_ = std::move(trouble); }

  /// Until stop() or `end`. Error: the system refuses a timer.
  Result<void> run(std::optional<Seconds> end = {});
  /// From within a callback.
  void stop() { stopped_ = true; }

  /// World time that was not simulated because the machine could not keep up.
  [[nodiscard]] Seconds skipped() const { return skipped_; }

private:
  struct Watcher {
    int fd;
    std::function<void()> readable;
  };
  void catchUp();
  void readPort();
  void look(int timer);

  World& world_;
  std::optional<Pty> port_;
  bool connected_ = false;
  std::vector<Watcher> watchers_;
  std::function<void(const std::string&)> trouble_;
  Seconds skipped_;
  bool stopped_ = false;
};

}  // namespace tessera::sim
