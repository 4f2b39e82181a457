#include "app/experiment/report.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/experiment/summary.h"

namespace tessera::experiment {

std::vector<Outcome> judge(const floor::SiteMap& map, const Recorder& recorder, const std::vector<TruthTrack>& truths,
                           MetresPerSecond asked) {
  std::vector<Outcome> outcomes;
  for (std::size_t i = 0; i < recorder.assignments().size(); ++i) {
    Outcome outcome;
    outcome.assignment = recorder.assignments()[i];
    if (const auto* vehicle = map.vehicle(outcome.assignment.vehicle)) outcome.name = vehicle->name;
    if (const auto* route = map.route(outcome.assignment.route)) outcome.route = Polyline{route->vertices};
    outcome.samples = pair(recorder.beliefs(i), truths.at(i));
    outcome.metrics = evaluate(outcome.route, outcome.samples, asked);
    outcome.finished = recorder.finished(i);
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

nlohmann::json summarise(const nlohmann::json& options, const std::vector<Outcome>& outcomes,
                         const Recorder& recorder) {
  nlohmann::json summary = nlohmann::json::object();
  summary["options"] = options;
  summary["vehicles"] = nlohmann::json::array();
  bool finished = true;
  for (const Outcome& outcome : outcomes) {
    nlohmann::json one = toJson(outcome.metrics, outcome.finished);
    one["vehicle"] = outcome.assignment.vehicle.value;
    one["name"] = outcome.name;
    one["route"] = outcome.assignment.route;
    if (summary["vehicles"].empty()) summary.update(toJson(outcome.metrics, outcome.finished));
    finished = finished && outcome.finished;
    summary["vehicles"].push_back(std::move(one));
  }
  summary["finished"] = finished;
  const supervisor::ChannelView& channel = recorder.channel();
  summary["channel"] = {{"cycle_s", channel.cycle.value()},
                        {"slot_s", channel.slot.value()},
                        {"air_factor", channel.airFactor},
                        {"delay_s", channel.delay.value()}};
  summary["events"] = nlohmann::json::array();
  for (const auto& event : recorder.events()) {
    summary["events"].push_back({{"time_s", event.time.value()},
                                 {"severity", supervisor::nameOf(event.severity)},
                                 {"kind", supervisor::nameOf(event.kind)},
                                 {"sentence", event.sentence}});
  }
  return summary;
}

Result<void> writeReport(const std::string& folder, const nlohmann::json& summary,
                         const std::vector<Outcome>& outcomes) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return failure("The folder " + folder + " could not be made: " + error.message() + ".");
  for (const Outcome& outcome : outcomes) {
    std::string file = folder;
    file += "/track";
    if (outcomes.size() > 1) file.append("-").append(std::to_string(outcome.assignment.vehicle.value));
    file += ".csv";
    if (auto written = writeTrackCsv(file, outcome.samples); !written) return written;
  }
  return writeWhole(folder + "/summary.json", summary.dump(2) + "\n");
}

}  // namespace tessera::experiment
