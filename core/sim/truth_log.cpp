#include "sim/truth_log.h"

#include <array>
#include <cstdio>

namespace tessera::sim {

Result<TruthLog> TruthLog::open(const std::string& path) {
  TruthLog log{path};
  log.file_ << "time_s,vehicle,x_m,y_m,heading_rad,v_mps,omega_radps" << std::endl;
  if (!log.file_) return failure("Cannot write the file of true poses " + path + ".");
  return log;
}

Result<void> TruthLog::write(const TrueState& s) {
  std::array<char, 160> row{};
  // Negative zero would make rows differ that are the same.
  const auto plain = [](double v) { return v + 0.0; };
  const int size =
      std::snprintf(row.data(), row.size(), "%.3f,%u,%.6f,%.6f,%.6f,%.5f,%.5f\n", s.time.value(),
                    unsigned{s.vehicle.value}, plain(s.pose.position.x.value()), plain(s.pose.position.y.value()),
                    plain(wrapped(s.pose.heading).value()), plain(s.speed.value()), plain(s.turnRate.value()));
  file_.write(row.data(), size);
  file_.flush();
  if (!file_) return failure("Cannot write to the file of true poses " + path_ + ".");
  return {};
}

}  // namespace tessera::sim
