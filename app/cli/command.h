// One sub-command of tessera-cli: adds its options, and leaves behind what is to be run when the words were right.
#pragma once

#include <CLI/App.hpp>
#include <functional>

namespace tessera::cli {

/// Set by the sub-command that the caller chose; returns an ExitCode.
using Run = std::function<int()>;

void addCharts(CLI::App& app, Run& run);
void addExperiment(CLI::App& app, Run& run);
void addDrive(CLI::App& app, Run& run);
void addPorts(CLI::App& app, Run& run);
void addRadio(CLI::App& app, Run& run);
void addSite(CLI::App& app, Run& run);

}  // namespace tessera::cli
