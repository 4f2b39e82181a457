// Writing what an experiment found: summary.json and track.csv.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/experiment/metrics.h"
#include "base/result.h"

namespace tessera::experiment {

/// The metrics of one vehicle under the names that the documentation lists, each with its unit in the name.
[[nodiscard]] nlohmann::json toJson(const Metrics& metrics, bool finished);

/// time_s, true x, y, heading, estimated x, y, heading, located, commanded speed and heading,
/// and whether the figures count this tick; metres and radians.
/// Error: names the file that could not be written.
[[nodiscard]] Result<void> writeTrackCsv(const std::string& file, const std::vector<Sample>& samples);

/// Reads the world's file of true poses and gives those of one vehicle. Error: names file and line.
[[nodiscard]] Result<TruthTrack> readTruth(const std::string& file, int vehicle);

/// Writes the whole text or nothing: to a file beside it first, then renamed. Error: names the file.
[[nodiscard]] Result<void> writeWhole(const std::string& file, const std::string& text);

}  // namespace tessera::experiment
