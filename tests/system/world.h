// tessera-world as a process of its own, with a hand that lets things happen in it and eyes that see what is true.
#pragma once

#include <QTemporaryDir>
#include <string>
#include <vector>

#include "base/pose.h"
#include "system/program.h"

namespace tessera::system_test {

class World {
public:
  /// Starts it on a site with further words; waits until its vehicles are switched on. `folder` outlives it and gets
  /// the link to the port, the true poses and the EEPROMs.
  World(const QTemporaryDir& folder, const std::string& site, const std::vector<std::string>& words);

  /// A path that stays the same when the port is pulled and plugged; empty: the world did not start.
  [[nodiscard]] const std::string& port() const { return port_; }
  /// Carries out a command. True: done; its answer stands in answer().
  bool order(const std::string& command);
  [[nodiscard]] const std::string& answer() const { return answer_; }
  /// Of the process that emulates the microcontroller; 0: none runs.
  [[nodiscard]] int emulatorId() const;
  [[nodiscard]] Program& program() { return program_; }

  /// Waits until a vehicle has been at a stand for a third of a second. How long after `since` (by the machine's
  /// monotonic clock, which is the world's too) it last moved; above a minute when it never came to a stand.
  [[nodiscard]] Seconds movedOnFor(Seconds since, int vehicle = 1) const;
  /// Where it is now, as the world says.
  [[nodiscard]] Point where(int vehicle = 1);

private:
  std::string truth_;
  Program program_;
  std::string port_;
  std::string answer_;
};

}  // namespace tessera::system_test
