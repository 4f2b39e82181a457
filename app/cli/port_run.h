// A run over a real port: the supervisor on its thread, the recorder on this one, until every vehicle is done, the
// time is up, or somebody presses Ctrl-C. Vehicles are stopped before it returns.
#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <vector>

#include "app/experiment/recorder.h"
#include "base/result.h"
#include "floor/site_map.h"
#include "supervisor/supervisor.h"

namespace tessera::cli {

class ProgressLine;

struct PortRunSpec {
  std::shared_ptr<const floor::SiteMap> map;
  supervisor::Config config;
  std::string port;  ///< as host::PortChoice::parse() takes it
  MetresPerSecond speed;
  Seconds limit;  ///< after the port was given
  bool printEvents = true;
};

enum class RunEnd { Finished, TimeUp, Interrupted };

/// Orders each assignment's route once its vehicle is connected. Events go to the progress line as they come.
/// Error: the supervisor could not be made or the port never opened.
[[nodiscard]] Result<RunEnd> runOnPort(const PortRunSpec& spec, experiment::Recorder& recorder, ProgressLine& progress);

/// How long a run may take before it is given up: three times what the longest route takes at this speed, and a minute.
[[nodiscard]] Seconds generousLimit(const floor::SiteMap& map, const std::vector<experiment::Assignment>& assignments,
                                    MetresPerSecond speed);

/// "ID=ROUTE" as given on the command line. Error: the word, and what is wrong with it on this site.
[[nodiscard]] Result<experiment::Assignment> parseAssignment(const std::string& word, const floor::SiteMap& map);

/// All of them. Error: that of a word, or a vehicle that is given two routes.
[[nodiscard]] Result<std::vector<experiment::Assignment>> parseAssignments(const std::vector<std::string>& words,
                                                                           const floor::SiteMap& map);

/// --drive, whose words have the form ID=ROUTE, and --limit.
CLI::Option* addDriveOption(CLI::App& command, std::vector<std::string>& words);
void addLimitOption(CLI::App& command, double& limit);

/// --estimator and --controller, each one of the names that there are; empty where not given.
void addMethods(CLI::App& command, std::string& estimator, std::string& controller);

}  // namespace tessera::cli
