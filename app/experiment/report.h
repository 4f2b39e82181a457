// What an experiment leaves in its folder: summary.json and, per vehicle, track.csv.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/experiment/metrics.h"
#include "app/experiment/recorder.h"
#include "base/result.h"
#include "floor/site_map.h"

namespace tessera::experiment {

/// One vehicle's run, judged.
struct Outcome {
  Assignment assignment;
  std::string name;  ///< of the vehicle
  Polyline route;
  std::vector<Sample> samples;
  Metrics metrics;
  bool finished = false;
};

/// truths: in the order of the recorder's assignments.
[[nodiscard]] std::vector<Outcome> judge(const floor::SiteMap& map, const Recorder& recorder,
                                         const std::vector<TruthTrack>& truths, MetresPerSecond asked);

/// Options as they were in force, the figures of each vehicle (those of the first also at the top), the channel as
/// it was at the end, and the events.
[[nodiscard]] nlohmann::json summarise(const nlohmann::json& options, const std::vector<Outcome>& outcomes,
                                       const Recorder& recorder);

/// Makes the folder and writes summary.json, and track.csv (track-ID.csv for every vehicle when there are several).
[[nodiscard]] Result<void> writeReport(const std::string& folder, const nlohmann::json& summary,
                                       const std::vector<Outcome>& outcomes);

}  // namespace tessera::experiment
