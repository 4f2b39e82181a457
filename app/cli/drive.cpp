// `tessera-cli drive`: supervises real vehicles (or any port that speaks like them) along routes, and tells what
// happens.
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/exit_codes.h"
#include "app/cli/output.h"
#include "app/cli/port_run.h"
#include "floor/site_json.h"

namespace tessera::cli {
namespace {

struct DriveWords {
  std::string site;
  std::string port;
  std::vector<std::string> drives;
  double speed = 0.12;
  double limit = 0;
  std::string estimator;
  std::string controller;
  bool json = false;
  bool quiet = false;
};

nlohmann::json resultOf(const experiment::Recorder& recorder) {
  nlohmann::json result{{"finished", recorder.allFinished()}, {"vehicles", nlohmann::json::array()}};
  for (std::size_t i = 0; i < recorder.assignments().size(); ++i) {
    const auto& assignment = recorder.assignments()[i];
    result["vehicles"].push_back(
        {{"vehicle", assignment.vehicle.value}, {"route", assignment.route}, {"finished", recorder.finished(i)}});
  }
  return result;
}

int drive(const DriveWords& words) {
  auto site = floor::loadSite(words.site);
  if (!site) return fail(words.json, site.error().sentence, kBadInput);
  auto map = floor::SiteMap::build(std::move(*site));
  if (!map) return fail(words.json, words.site + ": " + map.error().sentence.english(), kBadInput);
  PortRunSpec spec;
  spec.map = *map;
  spec.port = words.port;
  spec.speed = MetresPerSecond{words.speed};
  spec.config.locator = words.estimator;
  spec.config.controller = words.controller;
  const auto assignments = parseAssignments(words.drives, **map);
  if (!assignments) return fail(words.json, assignments.error().sentence, kBadInput);
  for (const experiment::Assignment& one : *assignments) spec.config.vehicles.push_back(one.vehicle);
  spec.limit = words.limit > 0 ? Seconds{words.limit} : generousLimit(**map, *assignments, spec.speed);
  experiment::Recorder recorder{*assignments};
  Result<RunEnd> end = RunEnd::TimeUp;
  {
    ProgressLine progress{words.quiet || words.json};
    end = runOnPort(spec, recorder, progress);
  }
  if (!end) return fail(words.json, end.error().sentence, kNoPort);
  if (words.json) {
    say(resultOf(recorder).dump(2));
  } else {
    say(recorder.progress() + ".");
    if (*end == RunEnd::TimeUp)
      say("The limit of " + std::to_string(std::lround(spec.limit.value())) + " s was over before all had arrived.");
  }
  if (*end == RunEnd::Interrupted) return kInterrupted;
  return *end == RunEnd::Finished ? kDone : kNotFinished;
}

}  // namespace

void addDrive(CLI::App& app, Run& run) {
  auto* command = app.add_subcommand("drive", "Drive vehicles along routes over a serial port or a device server");
  auto words = std::make_shared<DriveWords>();
  command->add_option("SITE", words->site, "A *.tessera.json file")->required();
  command
      ->add_option("--port", words->port,
                   "Port of the host's radio: a serial device, e.g. /dev/ttyUSB0, or a device server, tcp://HOST:PORT")
      ->required();
  addDriveOption(*command, words->drives)->required();
  command->add_option("--speed", words->speed, "Speed asked for, m/s")
      ->check(CLI::Range(0.01, 2.0))
      ->capture_default_str();
  addLimitOption(*command, words->limit);
  addMethods(*command, words->estimator, words->controller);
  command->add_flag("--json", words->json, "Print the result as JSON");
  command->add_flag("--quiet", words->quiet, "No progress");
  command->callback([words, &run] { run = [words] { return drive(*words); }; });
}

}  // namespace tessera::cli
