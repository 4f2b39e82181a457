// `tessera-cli site check`: reads a site as the supervisor would and says what is in it.
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/exit_codes.h"
#include "app/cli/output.h"
#include "floor/site_json.h"
#include "floor/site_map.h"

namespace tessera::cli {
namespace {

// "1 zone", "2 zones".
std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

int check(const std::string& file, bool asJson) {
  auto site = floor::loadSite(file);
  if (!site) return complain(site.error().sentence, kBadInput);
  auto map = floor::SiteMap::build(std::move(*site));
  if (!map) return complain(file + ": " + map.error().sentence.english(), kBadInput);
  const floor::Site& s = (*map)->site();
  const nlohmann::json counts{
      {"name", s.name},          {"tiles", s.placements.size()}, {"tags", (*map)->tags().size()},
      {"zones", s.zones.size()}, {"routes", s.routes.size()},    {"vehicles", s.vehicles.size()}};
  if (asJson) {
    say(counts.dump(2));
  } else {
    say(s.name + ": " + counted(s.placements.size(), "tile") + " laid, " + counted((*map)->tags().size(), "tag") +
        " registered, " + counted(s.zones.size(), "zone") + ", " + counted(s.routes.size(), "route") + ", " +
        counted(s.vehicles.size(), "vehicle") + ".");
  }
  return kDone;
}

}  // namespace

void addSite(CLI::App& app, Run& run) {
  auto* site = app.add_subcommand("site", "Work with site files");
  site->require_subcommand(1);
  auto* command = site->add_subcommand("check", "Read a site file and say what is in it, or what is wrong with it");
  struct Words {
    std::string file;
    bool json = false;
  };
  auto words = std::make_shared<Words>();
  command->add_option("FILE", words->file, "A *.tessera.json file")->required();
  command->add_flag("--json", words->json, "Print a JSON object");
  command->callback([words, &run] { run = [words] { return check(words->file, words->json); }; });
}

}  // namespace tessera::cli
