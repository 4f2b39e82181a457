#include "app/cli/site_convert.h"

#include <QDateTime>
#include <nlohmann/json.hpp>

#include "app/cli/exit_codes.h"
#include "app/cli/output.h"
#include "app/cli/site_output.h"
#include "exchange/file_format.h"
#include "exchange/lif.h"
#include "exchange/site_import.h"
#include "exchange/tag_tables.h"
#include "floor/json_node.h"
#include "floor/site_json.h"
#include "floor/site_map.h"
#include "floor/text_file.h"

namespace tessera::cli {
namespace {

using exchange::Preview;

struct ConvertWords {
  std::string in;
  std::string out;
  std::string to;
  std::string onto;
  bool force = false;
  bool json = false;
};

using exchange::Format;

// The word of --to.
std::string formatOf(const std::string& file) {
  switch (exchange::formatOfName(file).value_or(Format::Site)) {
    case Format::TagTable:
      return "csv";
    case Format::Layout:
      return "lif";
    case Format::Site:
      break;
  }
  return exchange::formatOfName(file) ? "json" : "";
}

Result<Preview> readFrom(const ConvertWords& words) {
  floor::Site onto;
  onto.name = stemOf(words.in);
  if (!words.onto.empty()) {
    auto site = floor::loadSite(words.onto);
    if (!site) return tl::unexpected{std::move(site.error())};
    onto = std::move(*site);
  }
  const auto text = floor::loadText(words.in, floor::kMostJson + 1);
  if (!text) return tl::unexpected{text.error()};
  switch (exchange::formatOf(words.in, *text)) {
    case Format::TagTable:
      return exchange::importTags(onto, *text, words.in);
    case Format::Layout:
      return exchange::importLif(onto, *text, words.in);
    case Format::Site:
      break;
  }
  if (!words.onto.empty()) return exchange::importSite(onto, *text, words.in);
  auto site = floor::parseSite(*text, words.in);
  if (!site) return tl::unexpected{std::move(site.error())};
  return Preview{std::move(*site), {}, {}};
}

struct Written {
  std::string text;
  std::vector<Sentence> leftOut;
};
Written writtenAs(const std::string& format, const floor::Site& site) {
  if (format == "csv") return {exchange::writeTileTags(site), exchange::leftOutOfTileTags(site)};
  if (format == "csv-places") return {exchange::writeTagPlaces(site), exchange::leftOutOfTagPlaces(site)};
  if (format == "json") return {writeSite(site), {}};
  auto lif = exchange::writeLif(site, QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString());
  return {std::move(lif.text), std::move(lif.leftOut)};
}

int convert(const ConvertWords& words) {
  const std::string format = words.to.empty() ? formatOf(words.out) : words.to;
  if (format.empty())
    return fail(words.json, "The ending of " + words.out + " says no format: add --to json, csv, csv-places or lif.",
                kUsage);
  if (formatOf(words.in) == "csv" && words.onto.empty())
    return fail(words.json, "A table of tags needs the site whose tags they are: add --onto SITE.", kUsage);
  const auto preview = readFrom(words);
  if (!preview) return fail(words.json, preview.error().sentence, kBadInput);
  // In a table or a layout nobody would see any more that one thing has two meanings.
  if (const auto map = floor::SiteMap::build(preview->site); !map)
    return fail(words.json, (words.onto.empty() ? words.in : words.onto) + ": " + map.error().sentence.english(),
                kBadInput);
  const Written written = writtenAs(format, preview->site);
  std::vector<Sentence> notes = preview->notes;
  notes.insert(notes.end(), written.leftOut.begin(), written.leftOut.end());
  const auto saved =
      saveText(written.text, words.out, words.force ? floor::Replacing::Allowed : floor::Replacing::Refused);
  if (!saved) return failToWrite(words.json, saved.error().sentence, words.out, words.force);
  if (words.json) {
    nlohmann::json result{{"written", words.out}, {"format", format}, {"notes", jsonOf(notes)}};
    result["changes"] = nlohmann::json::array();
    for (const sitediff::Change& change : preview->changes) result["changes"].push_back(jsonOf(change));
    say(result.dump(2));
    return kDone;
  }
  for (const sitediff::Change& change : preview->changes) say(change.sentence.english());
  for (const Sentence& note : notes) say(note.english());
  say("Written: " + words.out);
  return kDone;
}

}  // namespace

void addSiteConvert(CLI::App& site, Run& run) {
  auto words = std::make_shared<ConvertWords>();
  auto* command = site.add_subcommand(
      "convert",
      "Turn a site (*.tessera.json) into a table of its tags (*.csv) or a VDMA layout (*.lif.json), or back");
  command->add_option("IN", words->in, "A site, a table of tags or a layout, by its ending")->required();
  command->add_option("OUT", words->out, "The file to write")->required();
  command
      ->add_option(
          "--to", words->to,
          "Format of OUT; default: by its ending. csv: serial,index,uid of tiles; csv-places: x_m,y_m,uid of all "
          "tags")
      ->check(CLI::IsMember({"json", "csv", "csv-places", "lif"}));
  command->add_option("--onto", words->onto, "The site that a table, a layout or another site is read into");
  command->add_flag("--force", words->force, "Replace OUT if it is there");
  command->add_flag("--json", words->json, "Print what changed and what was left out as JSON");
  command->callback([words, &run] { run = [words] { return convert(*words); }; });
}

}  // namespace tessera::cli
