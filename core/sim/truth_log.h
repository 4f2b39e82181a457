// Where the vehicles truly are, written for judging a run afterwards. The supervisor never sees it.
#pragma once

#include <fstream>
#include <string>

#include "base/ids.h"
#include "base/pose.h"
#include "base/result.h"

namespace tessera::sim {

struct TrueState {
  Seconds time;  ///< of the world's clock
  VehicleId vehicle;
  Pose pose;
  MetresPerSecond speed;
  RadiansPerSecond turnRate;
};

/// CSV with a header line: time_s,vehicle,x_m,y_m,heading_rad,v_mps,omega_radps. Each row is on disk once written.
class TruthLog {
public:
  /// Begins the file anew. Error: it cannot be written.
  [[nodiscard]] static Result<TruthLog> open(const std::string& path);
  /// Error: the disk takes no more.
  Result<void> write(const TrueState& state);

private:
  explicit TruthLog(const std::string& path) : path_{path}, file_{path, std::ios::trunc} {}

  std::string path_;
  std::ofstream file_;
};

}  // namespace tessera::sim
