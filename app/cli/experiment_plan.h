// What `tessera-cli experiment` was told, and what a run needs, made from it and checked.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/experiment/recorder.h"
#include "app/world/world_options.h"
#include "base/result.h"
#include "floor/site_map.h"
#include "supervisor/supervisor.h"

namespace tessera::cli {

struct ExperimentWords {
  world::WorldOptions world;
  std::string kind = "native";
  std::string route;
  std::vector<std::string> drives;
  double speed = 0.12;
  std::string out = "out/experiment";
  std::string estimator;
  std::string controller;
  std::string magneticMap;
  double limit = 0;
  double carry = 0;
  std::optional<double> cornerCut;
  bool lockstep = false;
  bool json = false;
  bool quiet = false;
};

struct ExperimentPlan {
  std::shared_ptr<const floor::SiteMap> map;
  std::vector<experiment::Assignment> assignments;
  supervisor::Config config;
  MetresPerSecond speed;
  Seconds limit;
};

/// Error: a file that is no site, a route or vehicle that it does not have, or a method that nobody knows.
[[nodiscard]] Result<ExperimentPlan> planOf(const ExperimentWords& words);
/// Every option of the run by its name in summary.json, whether it was told or not, with the figure in force. As they
/// are told: a carry_s of 0 carries nothing, an empty magnetic_map or eeprom_dir is none, an empty firmware is the one
/// that comes with the program.
[[nodiscard]] nlohmann::json optionsOf(const ExperimentWords& words, const ExperimentPlan& plan);

}  // namespace tessera::cli
