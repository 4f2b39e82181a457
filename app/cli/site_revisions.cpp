#include "app/cli/site_revisions.h"

#include <QDateTime>
#include <QStandardPaths>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/exit_codes.h"
#include "app/cli/output.h"
#include "store/revisions.h"
#include "store/site_store.h"

namespace tessera::cli {
namespace {

using sitediff::Tally;
using store::Revision;

struct RevisionWords {
  std::string file;
  std::string database;
  bool json = false;
};

struct Counted {
  const char* key;
  const char* word;
  int Tally::*count;
};
constexpr std::array kCounted{Counted{"tiles_laid", "tiles laid", &Tally::laid},
                              Counted{"tiles_moved", "tiles moved", &Tally::moved},
                              Counted{"tiles_taken_up", "tiles taken up", &Tally::takenUp},
                              Counted{"tags", "tags", &Tally::tags},
                              Counted{"zones", "zones", &Tally::zones},
                              Counted{"routes", "routes", &Tally::routes},
                              Counted{"vehicles", "vehicles", &Tally::vehicles},
                              Counted{"others", "other changes", &Tally::others}};

// Where the window keeps them: the folder of the program `tessera` of the organisation "Tessera".
std::string windowsDatabase() {
  return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation).toStdString() +
         "/Tessera/tessera/tessera.sqlite";
}

std::string savedAt(const Revision& revision) {
  return QDateTime::fromMSecsSinceEpoch(revision.note.savedUtcMs, Qt::UTC).toString(Qt::ISODate).toStdString();
}

nlohmann::json jsonOf(const Revision& revision) {
  nlohmann::json changed = nullptr;
  if (revision.changed)
    for (const Counted& counted : kCounted) changed[counted.key] = (*revision.changed).*counted.count;
  return {{"id", revision.id},          {"saved_at", savedAt(revision)},        {"who", revision.note.who},
          {"what", revision.note.what}, {"found_in_file", revision.note.found}, {"changed", changed}};
}

std::string lineOf(const Revision& revision) {
  const auto& note = revision.note;
  std::string line = savedAt(revision) + "  " + (note.who.empty() ? "unknown" : note.who) + "  " +
                     (note.found          ? "the file as it was opened"
                      : note.what.empty() ? "saved without a step"
                                          : note.what);
  std::string changed;
  for (const Counted& counted : kCounted) {
    const int count = revision.changed ? (*revision.changed).*counted.count : 0;
    if (count > 0) changed += (changed.empty() ? "" : ", ") + std::string{counted.word} + ": " + std::to_string(count);
  }
  return changed.empty() ? line : line + "  (" + changed + ")";
}

int list(const RevisionWords& words) {
  const std::string file = words.database.empty() ? windowsDatabase() : words.database;
  if (std::error_code error; !std::filesystem::exists(file, error))
    return fail(words.json, file + ": is not there: no site was opened in the window on this computer.", kBadInput);
  const auto database = store::Database::open(file);
  if (!database) return fail(words.json, database.error().sentence, kBadInput);
  const auto revisions = store::Revisions{**database}.list(store::keyOfFile(words.file));
  if (!revisions) return fail(words.json, revisions.error().sentence, kBadInput);
  // A file that is gone may have revisions; a name that was never one has none.
  if (std::error_code error; revisions->empty() && !std::filesystem::exists(words.file, error))
    return fail(words.json, words.file + ": is not there, and no revision of it was kept.", kBadInput);
  if (words.json) {
    nlohmann::json all = nlohmann::json::array();
    for (const Revision& revision : *revisions) all.push_back(jsonOf(revision));
    say(nlohmann::json{{"file", store::keyOfFile(words.file)}, {"revisions", all}}.dump(2));
    return kDone;
  }
  for (const Revision& revision : *revisions) say(lineOf(revision));
  if (revisions->empty()) say("There are no revisions of " + words.file + ".");
  return kDone;
}

}  // namespace

void addSiteRevisions(CLI::App& site, Run& run) {
  auto words = std::make_shared<RevisionWords>();
  CLI::App* listing = site.add_subcommand("revisions", "List what the window kept of a site, the newest first");
  listing->add_flag("--json", words->json, "Print the result as JSON");
  listing->add_option("FILE", words->file, "The *.tessera.json file as it was opened or saved in the window")
      ->required();
  listing->add_option("--database", words->database, "The window's database; default: that of this user");
  listing->callback([words, &run] { run = [words] { return list(*words); }; });
}

}  // namespace tessera::cli
