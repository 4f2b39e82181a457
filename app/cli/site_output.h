// How the site commands say what they found: JSON for scripts, lines for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sitecheck/fault.h"
#include "sitediff/difference.h"

namespace tessera::cli {

[[nodiscard]] nlohmann::json jsonOf(const sitecheck::Fault& fault);
[[nodiscard]] nlohmann::json jsonOf(const sitediff::Change& change);
[[nodiscard]] nlohmann::json jsonOf(const std::vector<Sentence>& sentences);
/// "error    tiles-overlap at (1.20, 0.60) m: Tiles ..."
[[nodiscard]] std::string lineOf(const sitecheck::Fault& fault);

/// The name of a file without folder and endings: "hall" of "plans/hall.tessera.json".
[[nodiscard]] std::string stemOf(const std::string& file);

}  // namespace tessera::cli
