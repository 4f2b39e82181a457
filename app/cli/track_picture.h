// The picture and the sentence that sum an experiment up.
#pragma once

#include <string>
#include <vector>

#include "app/experiment/report.h"

namespace tessera::cli {

/// Error: names the file that could not be written.
[[nodiscard]] Result<void> drawTracks(const floor::SiteMap& map, const std::vector<experiment::Outcome>& outcomes,
                                      MetresPerSecond speed, std::uint64_t seed, const std::string& file);

/// "AGV 1 finished route paper in 48.2 s: position error 1.8 cm mean, …"
[[nodiscard]] std::string sentenceOf(const experiment::Outcome& outcome);

}  // namespace tessera::cli
