// `tessera-cli site`: makes, checks, compares and counts site files.
#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/exit_codes.h"
#include "app/cli/output.h"
#include "app/cli/site_convert.h"
#include "app/cli/site_output.h"
#include "app/cli/site_revisions.h"
#include "exchange/file_format.h"
#include "floor/new_floor.h"
#include "floor/site_json.h"
#include "floor/site_map.h"
#include "floor/site_names.h"
#include "floor/text_file.h"
#include "sitecheck/site_checker.h"
#include "sitediff/figures.h"

namespace tessera::cli {
namespace {

using floor::Site;

struct SiteWords {
  std::string file;
  std::vector<std::string> files;  ///< of a command that takes several
  std::string other;
  std::string tileType;
  std::string name;
  int columns = 0;
  int rows = 0;
  double speed = 0;
  double clearance = 0;
  bool practice = false;
  bool force = false;
  bool all = false;
  bool json = false;
};

// "1 zone", "2 zones".
std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

nlohmann::json countsOf(const Site& site, const sitediff::Figures& figures) {
  return {
      {"name", site.name},          {"tiles", site.placements.size()}, {"tags", figures.registered + figures.looseTags},
      {"zones", site.zones.size()}, {"routes", site.routes.size()},    {"vehicles", site.vehicles.size()}};
}

std::string sentenceOf(const Site& site, const sitediff::Figures& figures) {
  return site.name + ": " + counted(site.placements.size(), "tile") + " laid, " +
         counted(figures.registered + figures.looseTags, "tag") + " registered, " + counted(site.zones.size(), "zone") +
         ", " + counted(site.routes.size(), "route") + ", " + counted(site.vehicles.size(), "vehicle") + ".";
}

// Of a kind that a floor has hundreds of, a person reads a few.
void sayFaults(const sitecheck::Verdict& verdict, bool all) {
  constexpr std::size_t most = 20;
  std::array<std::size_t, sitecheck::kFaultKinds> told{};
  verdict.forEach([&](const sitecheck::Fault& fault) {
    std::size_t& ofKind = told.at(static_cast<std::size_t>(fault.kind));
    ofKind += fault.stands;
    if (ofKind <= most || all) say(lineOf(fault));
  });
  for (std::size_t kind = 0; kind < told.size() && !all; ++kind)
    if (told.at(kind) > most)
      say("... and " + std::to_string(told.at(kind) - most) + " more of " +
          std::string{codeOf(static_cast<sitecheck::FaultKind>(kind))} + "; --all lists them.");
}

struct FileReport {
  nlohmann::json json;
  int code = kDone;
};

// Each file by itself; the worst of all is the exit code, which counts up with what is bad.
int forEachFile(const SiteWords& words, FileReport (*report)(const SiteWords&, const Site&)) {
  nlohmann::json all = nlohmann::json::array();
  int worst = kDone;
  for (const std::string& file : words.files) {
    if (words.files.size() > 1 && !words.json) say(file + ":");
    SiteWords one = words;
    one.file = file;
    const auto site = floor::loadSite(file);
    FileReport result = site ? report(one, *site) : FileReport{{{"error", site.error().sentence.english()}}, kBadInput};
    if (!site) complain(site.error().sentence, kBadInput);
    result.json["file"] = file;
    worst = std::max(worst, result.code);
    all.push_back(std::move(result.json));
  }
  if (!words.json) return worst;
  say((words.files.size() > 1 ? all : all.front()).dump(2));
  return worst;
}

// A site in which one thing has two meanings is listed and counted, but nothing may be built on it.
void refuseContradiction(const SiteWords& words, const Site& site, FileReport& report) {
  const auto map = floor::SiteMap::build(site);
  if (map) return;
  const std::string sentence = words.file + ": " + map.error().sentence.english();
  report.code = complain(sentence, kBadInput);
  report.json["error"] = sentence;
}

FileReport checkOne(const SiteWords& words, const Site& site) {
  sitecheck::CheckOptions options;
  options.clearance = Metres{words.clearance};
  if (words.all || words.json) options.mostOfAKind = std::numeric_limits<std::size_t>::max();
  const sitecheck::Verdict verdict = sitecheck::checkSite(site, options);
  const auto figures = sitediff::figuresOf(site);
  const std::size_t errors = verdict.count(sitecheck::Severity::Error);
  FileReport report{countsOf(site, figures), errors > 0 ? kNotFinished : kDone};
  report.json["errors"] = errors;
  report.json["warnings"] = verdict.size() - errors;
  report.json["faults"] = nlohmann::json::array();
  if (words.json) {
    verdict.forEach([&](const sitecheck::Fault& fault) { report.json["faults"].push_back(jsonOf(fault)); });
  } else {
    say(sentenceOf(site, figures));
    sayFaults(verdict, words.all);
    say(counted(errors, "error") + ", " + counted(verdict.size() - errors, "warning") + ".");
  }
  refuseContradiction(words, site, report);
  return report;
}

int check(const SiteWords& words) { return forEachFile(words, checkOne); }

int make(const SiteWords& words) {
  if (exchange::formatOfName(words.file) != exchange::Format::Site)
    return fail(words.json, words.file + ": a site is written to a file *.tessera.json, or another *.json.", kUsage);
  floor::NewFloor wish{
      words.name.empty() ? stemOf(words.file) : words.name, {}, words.columns, words.rows, words.practice};
  for (const floor::TileType& type : floor::usualTileTypes())
    if (type.name == words.tileType) wish.type = type;
  const auto site = layNewFloor(wish);
  if (!site) return fail(words.json, site.error().sentence, kBadInput);
  const auto written =
      saveText(writeSite(*site), words.file, words.force ? floor::Replacing::Allowed : floor::Replacing::Refused);
  if (!written) return failToWrite(words.json, written.error().sentence, words.file, words.force);
  const auto figures = sitediff::figuresOf(*site);
  say(words.json ? countsOf(*site, figures).dump(2) : sentenceOf(*site, figures));
  return kDone;
}

int compare(const SiteWords& words) {
  const auto before = floor::loadSite(words.file);
  if (!before) return fail(words.json, before.error().sentence, kBadInput);
  const auto after = floor::loadSite(words.other);
  if (!after) return fail(words.json, after.error().sentence, kBadInput);
  const sitediff::Changes changes = sitediff::difference(*before, *after);
  if (words.json) {
    nlohmann::json result{{"equal", changes.empty()}, {"changes", nlohmann::json::array()}};
    for (const sitediff::Change& change : changes) result["changes"].push_back(jsonOf(change));
    say(result.dump(2));
  } else {
    for (const sitediff::Change& change : changes) say(change.sentence.english());
    if (changes.empty()) say("The sites are equal.");
  }
  return changes.empty() ? kDone : kNotFinished;
}

nlohmann::json jsonOfFigures(const sitediff::Figures& f) {
  nlohmann::json result{
      {"tiles_known", f.tilesKnown},      {"tiles_laid", f.tilesLaid},         {"tag_places", f.tagPlaces},
      {"tags_registered", f.registered},  {"loose_tags", f.looseTags},         {"floor_m2", f.floorSquareMetres},
      {"zones", nlohmann::json::array()}, {"routes", nlohmann::json::array()}, {"vehicles", f.vehicles}};
  for (const auto& zone : f.zones)
    result["zones"].push_back({{"name", zone.name},
                               {"kind", floor::kZoneKindNames.at(static_cast<std::size_t>(zone.kind))},
                               {"area_m2", zone.squareMetres}});
  for (const auto& route : f.routes)
    result["routes"].push_back({{"name", route.name},
                                {"length_m", route.length.value()},
                                {"stops", route.stops},
                                {"time_s", route.time.value()}});
  return result;
}

FileReport countOne(const SiteWords& words, const Site& site) {
  const auto f =
      sitediff::figuresOf(site, words.speed > 0 ? std::optional{MetresPerSecond{words.speed}} : std::nullopt);
  FileReport report{jsonOfFigures(f), kDone};
  refuseContradiction(words, site, report);
  if (words.json) return report;
  char text[700];
  const double share =
      f.tagPlaces == 0 ? 0.0 : 100.0 * static_cast<double>(f.registered) / static_cast<double>(f.tagPlaces);
  std::snprintf(text, sizeof text,
                "Tiles: %zu known, %zu laid, %.2f m². Tags: %zu of %zu registered (%.1f %%), %zu loose.", f.tilesKnown,
                f.tilesLaid, f.floorSquareMetres, f.registered, f.tagPlaces, share, f.looseTags);
  say(text);
  for (const auto& zone : f.zones) {
    std::snprintf(text, sizeof text, ": %.2f m²", zone.squareMetres);
    say("Zone " + zone.name + ", " + std::string{floor::kZoneKindNames.at(static_cast<std::size_t>(zone.kind))} + text);
  }
  for (const auto& route : f.routes) {
    std::snprintf(text, sizeof text, ": %.2f m, %d stops, %.0f s", route.length.value(), route.stops,
                  route.time.value());
    say("Route " + route.name + text);
  }
  return report;
}

int count(const SiteWords& words) { return forEachFile(words, countOne); }

std::vector<std::string> tileTypeNames() {
  std::vector<std::string> names;
  for (const floor::TileType& type : floor::usualTileTypes()) names.push_back(type.name);
  return names;
}

CLI::App* addPart(CLI::App& site, const char* name, const char* help, const std::shared_ptr<SiteWords>& words,
                  int (*what)(const SiteWords&), Run& run) {
  CLI::App* part = site.add_subcommand(name, help);
  part->add_flag("--json", words->json, "Print the result as JSON");
  part->callback([words, what, &run] { run = [words, what] { return what(*words); }; });
  return part;
}

}  // namespace

void addSite(CLI::App& app, Run& run) {
  auto* site = app.add_subcommand("site", "Make, check, convert, compare and count site files");
  site->require_subcommand(1);
  auto words = std::make_shared<SiteWords>();
  constexpr const char* kFile = "A *.tessera.json file";
  constexpr const char* kFiles = "*.tessera.json files";
  auto* making = addPart(*site, "new", "Write a floor of equal tiles, side by side", words, make, run);
  making->add_option("OUT", words->file, "The file to write: *.tessera.json")->required();
  making->add_option("--tile-type", words->tileType, "Size, pattern and pitch of the tiles")
      ->required()
      ->check(CLI::IsMember(tileTypeNames()));
  making->add_option("--columns", words->columns, "Tiles along x")
      ->required()
      ->check(CLI::Range(1, floor::NewFloor::kMost));
  making->add_option("--rows", words->rows, "Tiles along y")->required()->check(CLI::Range(1, floor::NewFloor::kMost));
  making->add_option("--name", words->name, "The site's name; default: the file's");
  making->add_flag("--practice", words->practice, "Made-up UIDs and one vehicle, to try it in the simulated world");
  making->add_flag("--force", words->force, "Replace the file if it is there");
  auto* checking = addPart(
      *site, "check",
      "Read site files and list their faults. The exit code is the worst of all; with --json an "
      "object, of several files an array of such, one that cannot be read or contradicts itself with its \"error\"",
      words, check, run);
  checking->add_option("FILE", words->files, kFiles)->required();
  checking->add_flag("--all", words->all, "List every fault; default: 20 of each kind");
  checking->add_option("--clearance", words->clearance, "Room around vehicles on routes, m; default: none")
      ->check(CLI::Range(0.0, 2.0));
  addSiteConvert(*site, run);
  auto* comparing = addPart(*site, "diff", "Say what changes from one site to another", words, compare, run);
  comparing->add_option("BEFORE", words->file, kFile)->required();
  comparing->add_option("AFTER", words->other, kFile)->required();
  auto* counting =
      addPart(*site, "stats",
              "Count tiles, tags, areas, lengths and travel times. --json and the exit code as of check, but faults "
              "alone are not looked for: 3 where one thing has two meanings",
              words, count, run);
  counting->add_option("FILE", words->files, kFiles)->required();
  counting->add_option("--speed", words->speed, "On the routes, m/s; default: the vehicle's highest")
      ->check(CLI::Range(0.01, 20.0));
  addSiteRevisions(*site, run);
  for (CLI::App* sub : site->get_subcommands({})) sub->footer(kExitCodeHelp);
}

}  // namespace tessera::cli
