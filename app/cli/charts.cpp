// `tessera-cli charts`: pictures of many runs from the tables that bench/experiments.py leaves.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/exit_codes.h"
#include "app/cli/output.h"
#include "app/cli/run_table.h"
#include "ui/plot/chart_frame.h"
#include "ui/plot/run_charts.h"

namespace tessera::cli {
namespace {

constexpr double kCmPerM = 100.0;

struct ChartWords {
  std::vector<std::string> files;
  std::string by = "controller";
  std::string out = "out/charts";
  bool json = false;
};

using Series = std::pair<std::string, std::vector<const RunLine*>>;

/// Runs by what tells them apart, in the order in which they come.
std::vector<Series> seriesOf(const std::vector<RunLine>& runs) {
  std::vector<Series> all;
  for (const RunLine& run : runs) {
    auto it = std::find_if(all.begin(), all.end(), [&](const Series& one) { return one.first == run.series; });
    if (it == all.end()) it = all.insert(it, {run.series, {}});
    it->second.push_back(&run);
  }
  return all;
}

ui::SpeedPanel panelOf(const std::string& label, const std::vector<Series>& all, double RunLine::*figure,
                       double scale) {
  ui::SpeedPanel panel{label, {}};
  for (const auto& [name, runs] : all) {
    std::map<double, std::vector<double>> bySpeed;
    for (const RunLine* run : runs) bySpeed[run->speed].push_back(run->*figure * scale);
    ui::SpeedSeries series{name, {}};
    for (const auto& [speed, values] : bySpeed) {
      double sum = 0.0;
      for (const double value : values) sum += value;
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      series.points.push_back({speed * kCmPerM, sum / static_cast<double>(values.size()), *low, *high});
    }
    panel.series.push_back(std::move(series));
  }
  return panel;
}

Result<std::vector<ui::ErrorSeries>> errorsOf(const std::vector<Series>& all) {
  std::vector<ui::ErrorSeries> found;
  for (const auto& [name, runs] : all) {
    ui::ErrorSeries series{name, {}};
    for (const RunLine* run : runs) {
      auto errors = readErrors(run->track);
      if (!errors) return tl::unexpected{errors.error()};
      for (const double error : *errors) series.errors.push_back(error * kCmPerM);
    }
    found.push_back(std::move(series));
  }
  return found;
}

std::vector<ui::HonestySeries> honestyOf(const std::vector<Series>& all) {
  std::vector<ui::HonestySeries> found;
  for (const auto& [name, runs] : all) {
    ui::HonestySeries series{name, {}};
    for (const RunLine* run : runs) series.runs.push_back({run->neesMean, run->neesLow, run->neesHigh});
    found.push_back(std::move(series));
  }
  return found;
}

// What is drawn, each with its file's name; the first that fails ends it.
Result<std::vector<std::string>> draw(const std::vector<Series>& all, const std::vector<ui::ErrorSeries>& errors,
                                      std::size_t runs, const std::string& folder) {
  const std::string count = std::to_string(runs) + (runs == 1 ? " run" : " runs");
  const std::string against = ", against speed (" + count + ": mean, least and largest)";
  const std::vector<std::pair<std::string, std::function<Result<void>(const QString&)>>> pictures{
      {"errors.png",
       [&](const QString& file) {
         return ui::saveErrorChart("Position errors at all ticks of " + count, errors, file);
       }},
      {"speed.png",
       [&](const QString& file) {
         return ui::saveSpeedChart("Position error" + against,
                                   {panelOf("Mean position error [cm]", all, &RunLine::positionError, kCmPerM)}, file);
       }},
      {"nees.png",
       [&](const QString& file) {
         return ui::saveHonestyChart("How honest the locator's claims are: mean NEES of " + count, honestyOf(all),
                                     file);
       }},
      {"tracking.png", [&](const QString& file) {
         return ui::saveSpeedChart("Distance from the route and turning back" + against,
                                   {panelOf("Cross-track RMS [cm]", all, &RunLine::crossTrack, kCmPerM),
                                    panelOf("Reversals in a run", all, &RunLine::reversals, 1.0)},
                                   file);
       }}};
  std::vector<std::string> drawn;
  for (const auto& [name, save] : pictures) {
    const auto file = std::filesystem::absolute(folder).lexically_normal() / name;
    if (auto saved = save(QString::fromStdString(file.string())); !saved) return tl::unexpected{saved.error()};
    drawn.push_back(file.string());
  }
  return drawn;
}

int chartsMain(const ChartWords& words) {
  RunTable table;
  for (const std::string& file : words.files) {
    auto one = readRuns(file, words.by);
    if (!one) return fail(words.json, one.error().sentence.english(), kBadInput);
    table.leftOut += one->leftOut;
    std::move(one->runs.begin(), one->runs.end(), std::back_inserter(table.runs));
  }
  const auto all = seriesOf(table.runs);
  if (all.size() > ui::kChartColours)
    return fail(words.json,
                "The runs say " + std::to_string(all.size()) + " different things under " + words.by +
                    ", and charts tell at most " + std::to_string(ui::kChartColours) + " apart.",
                kBadInput);
  const auto errors = errorsOf(all);
  if (!errors) return fail(words.json, errors.error().sentence.english(), kBadInput);
  std::error_code error;
  std::filesystem::create_directories(words.out, error);
  if (error)
    return fail(words.json, "The folder " + words.out + " could not be made: " + error.message() + ".", kCannotWrite);
  const auto drawn = draw(all, *errors, table.runs.size(), words.out);
  if (!drawn) return fail(words.json, drawn.error().sentence.english(), kCannotWrite);
  if (words.json) {
    say(nlohmann::json{{"pictures", *drawn}, {"runs", table.runs.size()}, {"left_out", table.leftOut}}.dump(2));
    return kDone;
  }
  for (const std::string& file : *drawn) say("Picture: " + file);
  if (table.leftOut > 0) say("Left out, as they gave no figures: " + std::to_string(table.leftOut) + " runs.");
  return kDone;
}

}  // namespace

void addCharts(CLI::App& app, Run& run) {
  auto* command = app.add_subcommand(
      "charts",
      "Draw many runs of an experiment from runs.csv: errors.png (how position errors are spread), speed.png (position "
      "error against speed), nees.png (honesty of each run), tracking.png (distance from the route and reversals "
      "against speed)");
  auto words = std::make_shared<ChartWords>();
  command->add_option("RUNS", words->files, "Tables runs.csv of bench/experiments.py")->required();
  command->add_option("--by", words->by, "Column of these tables that tells the series of a chart apart")
      ->capture_default_str();
  command->add_option("--out", words->out, "Folder for the pictures")->capture_default_str();
  command->add_flag("--json", words->json, "Print the pictures' names as JSON");
  command->callback([words, &run] { run = [words] { return chartsMain(*words); }; });
}

}  // namespace tessera::cli
