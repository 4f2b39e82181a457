// `tessera-cli experiment`: drives routes in a simulated world, and judges the drive by what was true.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/exit_codes.h"
#include "app/cli/experiment_plan.h"
#include "app/cli/magnetic_map_file.h"
#include "app/cli/output.h"
#include "app/cli/port_run.h"
#include "app/cli/track_picture.h"
#include "app/experiment/carried.h"
#include "app/experiment/lockstep.h"
#include "app/experiment/report.h"
#include "app/experiment/summary.h"
#include "app/process/world_process.h"
#include "app/world/make_world.h"
#include "app/world/world_options.h"
#include "sim/random_stream.h"
#include "sim/site_bounds.h"

namespace tessera::cli {
namespace {

constexpr Metres kCarriedAtLeast{0.3};

// Somebody lifts a vehicle while it drives and sets it down anywhere on the floor's middle, turned by any angle.
void liftAndSetDown(sim::World& world, const ExperimentPlan& plan, VehicleId vehicle, std::uint64_t seed) {
  sim::RandomStream random{seed, "carried"};
  const auto bounds = sim::boundsOf(plan.map->site());
  const auto truth = world.truth(vehicle);
  if (!bounds || !truth) return;
  const Offset size = bounds->upperRight - bounds->lowerLeft;
  for (int tries = 0; tries < 100; ++tries) {
    const Offset from{size.x * random.between(0.3, 0.7), size.y * random.between(0.3, 0.7)};
    const Offset by = bounds->lowerLeft + from - truth->pose.position;
    if (length(by) < kCarriedAtLeast) continue;
    world.push(vehicle, by, Radians{random.between(-kPi, kPi)});
    return;
  }
}

// A run in virtual time, in this process.
Result<RunEnd> runLockstep(const ExperimentPlan& plan, const ExperimentWords& words, experiment::Recorder& recorder,
                           ProgressLine& progress, std::optional<Seconds>& carriedAt) {
  auto made = world::makeWorld(words.world, Seconds{});
  if (!made) return tl::unexpected{made.error()};
  auto supervisor = supervisor::Supervisor::create(plan.map, plan.config);
  if (!supervisor) return tl::unexpected{supervisor.error()};
  if (auto started = made->world->startAll(); !started) return tl::unexpected{started.error()};
  experiment::Lockstep lockstep{*made->world, *supervisor, recorder};
  if (!lockstep.run(Seconds{60}, [&] { return recorder.allConnected(); })) return RunEnd::TimeUp;
  for (const auto& assignment : recorder.assignments()) {
    supervisor->post(supervisor::RunRoute{assignment.vehicle, assignment.route, plan.speed});
  }
  const Seconds ordered = lockstep.now();
  const bool done = lockstep.run(ordered + plan.limit, [&] {
    if (words.carry > 0 && !carriedAt && lockstep.now() >= ordered + Seconds{words.carry}) {
      carriedAt = lockstep.now();
      liftAndSetDown(*made->world, plan, plan.assignments.front().vehicle, words.world.seed);
    }
    progress.show(recorder.share(), recorder.progress());
    return recorder.allFinished();
  });
  if (auto kept = keepMagneticMap(words.magneticMap, lockstep.snapshot().get()); !kept)
    return tl::unexpected{kept.error()};
  return done ? RunEnd::Finished : RunEnd::TimeUp;
}

// A run in real time over a pty: the world in a process of its own.
Result<RunEnd> runThroughPty(const ExperimentPlan& plan, const ExperimentWords& words, experiment::Recorder& recorder,
                             ProgressLine& progress, std::vector<std::string>& complaints) {
  process::WorldProcess process;
  QObject::connect(&process, &process::WorldProcess::complained, [&](const QString& line) {
    complaints.push_back(line.toStdString());
    static_cast<void>(complain(line.toStdString(), kDone));
  });
  progress.note("Setting the simulated world up: each vehicle calibrates its compass.");
  if (auto started = process.start(world::worldArguments(words.world)); !started) {
    return tl::unexpected{started.error()};
  }
  progress.note("The radio stands at " + process.port() + ".");
  PortRunSpec spec{plan.map, plan.config, process.port(), plan.speed, plan.limit, true};
  auto end = runOnPort(spec, recorder, progress);
  process.stop();
  return end;
}

int conclude(const ExperimentWords& words, const ExperimentPlan& plan, const experiment::Recorder& recorder,
             const std::vector<std::string>& complaints, std::optional<Seconds> carriedAt, RunEnd end) {
  std::vector<experiment::TruthTrack> truths;
  for (const auto& assignment : plan.assignments) {
    auto truth = experiment::readTruth(words.world.truth, assignment.vehicle.value);
    if (!truth) return fail(words.json, truth.error().sentence, kBadInput);
    truths.push_back(std::move(*truth));
  }
  const auto outcomes = experiment::judge(*plan.map, recorder, truths, plan.speed);
  nlohmann::json summary = experiment::summarise(optionsOf(words, plan), outcomes, recorder);
  // Figures of a world that could not keep step are worth nothing.
  summary["world_complaints"] = complaints;
  if (carriedAt) {
    const auto found = experiment::foundAfter(outcomes.front().samples, *carriedAt);
    summary["carried"] = {{"time_s", carriedAt->value()},
                          {"found", found.has_value()},
                          {"found_after_m", found.value_or(Metres{}).value()},
                          {"wrongly_sure_s", experiment::wronglySure(outcomes.front().samples, *carriedAt).value()}};
  }
  if (auto written = experiment::writeReport(words.out, summary, outcomes); !written) {
    return fail(words.json, written.error().sentence, kCannotWrite);
  }
  const std::string picture = words.out + "/track.png";
  if (auto drawn = drawTracks(*plan.map, outcomes, plan.speed, words.world.seed, picture); !drawn) {
    return fail(words.json, drawn.error().sentence, kCannotWrite);
  }
  if (words.json) {
    say(summary.dump(2));
  } else {
    for (const auto& outcome : outcomes) say(sentenceOf(outcome));
    say("Picture: " + std::filesystem::absolute(picture).lexically_normal().string());
  }
  if (end == RunEnd::Interrupted) return kInterrupted;
  return end == RunEnd::Finished ? kDone : kNotFinished;
}

int experimentMain(ExperimentWords words) {
  words.world.kind = words.kind == "qemu" ? world::Kind::Qemu : world::Kind::Native;
  if (words.carry > 0 && !words.lockstep)
    return fail(words.json, "Carrying a vehicle (--carry) needs --lockstep.", kUsage);
  if (words.lockstep && words.world.kind == world::Kind::Qemu) {
    return fail(words.json, "An emulated vehicle runs in real time: leave out --lockstep, or take --vehicle native.",
                kUsage);
  }
  if (!words.magneticMap.empty() && !words.lockstep)
    return complain("A magnetic map (--magnetic-map) needs --lockstep.", kUsage);
  if (words.route.empty() && words.drives.empty())
    return fail(words.json, "Name a route with --route NAME, or vehicles and routes with --drive ID=ROUTE.", kUsage);
  auto plan = planOf(words);
  if (!plan) return fail(words.json, plan.error().sentence, kBadInput);
  for (const auto& id : plan->config.vehicles) words.world.vehicles.push_back(id.value);
  std::error_code error;
  std::filesystem::create_directories(words.out, error);
  if (error)
    return fail(words.json, "The folder " + words.out + " could not be made: " + error.message() + ".", kCannotWrite);
  words.world.truth = words.out + "/truth.csv";
  if (auto kept = experiment::writeWhole(words.world.truth, {}); !kept)
    return fail(words.json, kept.error().sentence, kCannotWrite);

  experiment::Recorder recorder{plan->assignments};
  std::vector<std::string> complaints;
  std::optional<Seconds> carriedAt;
  Result<RunEnd> end = RunEnd::TimeUp;
  {
    ProgressLine progress{words.quiet || words.json};
    end = words.lockstep ? runLockstep(*plan, words, recorder, progress, carriedAt)
                         : runThroughPty(*plan, words, recorder, progress, complaints);
  }
  if (!end) return fail(words.json, end.error().sentence, kNoPort);
  return conclude(words, *plan, recorder, complaints, carriedAt, *end);
}

}  // namespace

void addExperiment(CLI::App& app, Run& run) {
  auto* command = app.add_subcommand(
      "experiment", "Drive routes in a simulated world and measure how well: summary.json, track.csv, track.png");
  auto words = std::make_shared<ExperimentWords>();
  command->add_option("SITE", words->world.site, "A *.tessera.json file")->required();
  command->add_option("--route", words->route, "Route for the site's first vehicle");
  addDriveOption(*command, words->drives);
  command->add_option("--speed", words->speed, "Speed asked for, m/s")
      ->check(CLI::Range(0.01, 2.0))
      ->capture_default_str();
  command
      ->add_option("--vehicle", words->kind, "Firmware in the emulated microcontroller, or compiled for this machine")
      ->check(CLI::IsMember({"qemu", "native"}))
      ->capture_default_str();
  command->add_option("--firmware", words->world.firmware, "ELF for --vehicle qemu; default: beside this program");
  command->add_option("--out", words->out, "Folder for the results")->capture_default_str();
  addMethods(*command, words->estimator, words->controller);
  addLimitOption(*command, words->limit);
  command->add_flag("--lockstep", words->lockstep,
                    "Virtual time in one process, without a port: faster, and the same each time (native only)");
  command
      ->add_option("--carry", words->carry,
                   "Lift the first vehicle after so many seconds and set it down elsewhere (lockstep only)")
      ->check(CLI::Range(0.1, 1e6));
  command
      ->add_option("--corner-cut", words->cornerCut,
                   "Round sharp corners and leave their vertices by so many metres at most; 0: turn on the spot; "
                   "default: as the site says")
      ->check(CLI::Range(0.0, floor::kMostCornerCut.value()));
  command->add_option("--magnetic-map", words->magneticMap,
                      "Locate vehicles by what earlier drives have learned of the floor's iron, kept in this file, and "
                      "learn on (lockstep only)");
  command->add_flag("--json", words->json, "Print the summary as JSON");
  command->add_flag("--quiet", words->quiet, "No progress");
  world::addWorldConditions(*command, words->world);
  command->callback([words, &run] { run = [words] { return experimentMain(*words); }; });
}

}  // namespace tessera::cli
