// tessera-cli: everything that Tessera does without a window.
#include <CLI/CLI.hpp>
#include <QApplication>
#include <cstdio>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/exit_codes.h"
#include "app/cli/output.h"
#include "app/process/runtime_folder.h"

int main(int argc, char** argv) {
  using namespace tessera::cli;
  // Charts are drawn by widgets, which need a platform; this one needs no display.
  qputenv("QT_QPA_PLATFORM", "offscreen");
  tessera::process::provideRuntimeFolder();

  CLI::App app{"Tessera without a window: supervise vehicles on an RFID tile floor, check sites, run experiments.",
               "tessera-cli"};
  app.set_version_flag("--version", TESSERA_VERSION);
  app.set_help_all_flag("--help-all", "Help for every sub-command");
  app.require_subcommand(1);
  app.footer(kExitCodeHelp);
  Run run;
  addExperiment(app, run);
  addCharts(app, run);
  addDrive(app, run);
  addPorts(app, run);
  addRadio(app, run);
  addSite(app, run);
  for (CLI::App* sub : app.get_subcommands({})) sub->footer(kExitCodeHelp);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    // CLI11 tells only that a sub-command is missing, or helps, where one was given that there is not.
    std::string parent;
    const CLI::App* at = &app;
    for (; !at->get_subcommands().empty(); at = at->get_subcommands().back())
      parent += at->get_subcommands().back()->get_name() + " ";
    if (const auto words = at->remaining(); at->get_require_subcommand_min() > 0 && !words.empty())
      return complain("There is no sub-command \"" + parent + words.front() + "\"; see " +
                          (parent.empty() ? "" : "tessera-cli " + parent) + "--help.",
                      kUsage);
    const int asked = app.exit(e);  // prints help, the version or what is wrong
    return asked == 0 ? kDone : kUsage;
  }
  QApplication application{argc, argv};
  const int code = run();
  // What could not be printed, on a full disk say, was not done.
  const bool printed = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.flush().good();
  return code == kDone && !printed ? complain("The result could not be printed.", kCannotWrite) : code;
}
