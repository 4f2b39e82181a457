#include "exchange/tag_tables.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_map>

#include "exchange/csv.h"
#include "exchange/tag_places.h"

namespace tessera::exchange {
namespace {

using floor::Site;
using floor::TagUid;
using floor::Tile;

std::string decimal(Metres m) {
  char text[64];
  const double v = m.value() == 0.0 ? 0.0 : m.value();
  return {text, std::to_chars(text, text + sizeof text, v).ptr};
}

std::string shown(std::string_view text) {
  std::string s = "\"" + std::string{text.substr(0, 40)} + (text.size() > 40 ? "...\"" : "\"");
  std::replace_if(
      s.begin(), s.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, '?');
  return s;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

class TableImport {
public:
  TableImport(Site site, const std::vector<CsvRow>& rows, const std::string& name)
      : site_{std::move(site)}, rows_{rows}, name_{name} {}

  Result<Site> tiles() {
    for (std::size_t i = 0; i < site_.tiles.size(); ++i) tileOf_.try_emplace(site_.tiles[i].serial, i);
    for (const floor::TileType& type : site_.tileTypes) tagsOf_.try_emplace(type.name, tagOffsets(type).size());
    for (std::size_t i = 1; i < rows_.size() && !error_; ++i) tileRow(rows_[i]);
    return finish();
  }
  /// before: the site as it was.
  Result<Site> places(const Site& before) {
    const TagPlaces tags{before};
    for (std::size_t i = 0; i < site_.looseTags.size(); ++i) looseOf_.try_emplace(site_.looseTags[i].uid, i);
    for (std::size_t i = 1; i < rows_.size() && !error_; ++i) placeRow(rows_[i], tags);
    return finish();
  }
  /// Lines that meant the tag of a tile.
  [[nodiscard]] std::size_t onTiles() const { return given_.size(); }

private:
  void fail(const CsvRow& row, const Sentence& sentence) {
    if (!error_) error_ = Error{phrase("Core", "%1: line %2: %3").with(name_, row.line, sentence)};
  }

  void tileRow(const CsvRow& row) {
    const auto tile = tileOf_.find(row.fields[0]);
    if (tile == tileOf_.end()) return fail(row, phrase("Core", "the site has no tile %1.").with(shown(row.fields[0])));
    const Tile& t = site_.tiles[tile->second];
    const auto tags = tagsOf_.find(t.type);
    const std::size_t most = tags == tagsOf_.end() ? 0 : tags->second;
    std::size_t index = 0;
    const std::string_view text = trimmed(row.fields[1]);
    const auto read = std::from_chars(text.data(), text.data() + text.size(), index);
    if (read.ec != std::errc{} || read.ptr != text.data() + text.size() || index < 1 || index > most)
      return fail(row, phrase("Core", "expected an index from 1 to %1, found %2.").with(most, shown(text)));
    TagUid uid;
    if (const std::string_view digits = trimmed(row.fields[2]); !digits.empty()) {
      const auto parsed = TagUid::parse(digits);
      if (!parsed) return fail(row, parsed.error().sentence);
      uid = *parsed;
    }
    set(row, {tile->second, index - 1}, uid);
    if (!uid.empty()) lineOf_.try_emplace(uid, &row);
  }

  void set(const CsvRow& row, TileTag tag, const TagUid& uid) {
    const std::size_t place = (tag.tile << 16U) | tag.tag;
    if (const auto [first, isNew] = given_.try_emplace(place, row.line); !isNew)
      return fail(row, phrase("Core", "this tag stands already in line %1.").with(first->second));
    std::vector<TagUid>& uids = site_.tiles[tag.tile].uids;
    if (uids.size() <= tag.tag) uids.resize(tag.tag + 1);
    uids[tag.tag] = uid;
  }

  std::optional<Metres> coordinate(const CsvRow& row, std::size_t field) {
    const std::string_view text = trimmed(row.fields[field]);
    double v = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), v);
    if (read.ec == std::errc{} && read.ptr == text.data() + text.size() && std::abs(v) <= 100'000.0)
      return Metres{v == 0.0 ? 0.0 : v};
    fail(row, phrase("Core", "expected metres from -100000 to 100000, found %1.").with(shown(text)));
    return std::nullopt;
  }

  void placeRow(const CsvRow& row, const TagPlaces& tags) {
    const auto x = coordinate(row, 0);
    const auto y = coordinate(row, 1);
    const auto uid = TagUid::parse(trimmed(row.fields[2]));
    if (!uid) return fail(row, uid.error().sentence);
    if (!x || !y) return;
    if (const auto [first, isNew] = lineOf_.try_emplace(*uid, &row); !isNew)
      return fail(row, phrase("Core", "tag %1 stands already in line %2.").with(uid->text(), first->second->line));
    if (const auto known = looseOf_.find(*uid); known != looseOf_.end())
      site_.looseTags[known->second].place = {*x, *y};
    else if (const auto tag = tags.at({*x, *y}, kSamePlace, *uid))
      set(row, *tag, *uid);
    else
      site_.looseTags.push_back({*uid, {*x, *y}});
  }

  // A UID of the table must stand at one place alone in what the site has become.
  Result<Site> finish() {
    std::unordered_map<TagUid, Sentence> places;
    const auto put = [&](const TagUid& uid, const auto& describe) {
      const auto line = lineOf_.find(uid);
      if (uid.empty() || line == lineOf_.end()) return;
      const auto [first, isNew] = places.try_emplace(uid, describe());
      if (!isNew)
        fail(*line->second, phrase("Core", "tag %1 would be registered twice: as %2 and as %3.")
                                .with(uid.text(), first->second, describe()));
    };
    for (const Tile& tile : site_.tiles)
      for (std::size_t n = 0; n < tile.uids.size(); ++n)
        put(tile.uids[n], [&] { return phrase("Core", "tag %1 of tile \"%2\"").with(n + 1, tile.serial); });
    for (const floor::LooseTag& tag : site_.looseTags)
      put(tag.uid, [] { return Sentence{phrase("Core", "a loose tag")}; });
    if (error_) return tl::unexpected{std::move(*error_)};
    return std::move(site_);
  }

  Site site_;
  const std::vector<CsvRow>& rows_;
  const std::string& name_;
  std::optional<Error> error_;
  std::unordered_map<std::string, std::size_t> tileOf_;
  std::unordered_map<std::string, std::size_t> tagsOf_;
  std::unordered_map<TagUid, std::size_t> looseOf_;
  std::unordered_map<std::size_t, std::size_t> given_;  ///< tile and index -> line
  std::unordered_map<TagUid, const CsvRow*> lineOf_;
};

bool isHeader(const CsvRow& row, const char* a, const char* b, const char* c) {
  return row.fields.size() == 3 && trimmed(row.fields[0]) == a && trimmed(row.fields[1]) == b &&
         trimmed(row.fields[2]) == c;
}

}  // namespace

std::string writeTileTags(const Site& site) {
  std::string s = "serial,index,uid\n";
  for (const Tile& tile : site.tiles)
    for (std::size_t n = 0; n < tile.uids.size(); ++n)
      s += csvField(tile.serial) + "," + std::to_string(n + 1) + "," + tile.uids[n].text() + "\n";
  return s;
}

std::string writeTagPlaces(const Site& site) {
  const auto line = [](Metres x, Metres y, const TagUid& uid) {
    return decimal(x) + "," + decimal(y) + "," + uid.text() + "\n";
  };
  const auto rounded = [](Metres m) { return Metres{std::round(m.value() * 1e6) / 1e6}; };
  std::string s = "x_m,y_m,uid\n";
  TagPlaces{site}.forEachRegistered(
      [&](const TagUid& uid, Point place) { s += line(rounded(place.x), rounded(place.y), uid); });
  for (const floor::LooseTag& tag : site.looseTags) s += line(tag.place.x, tag.place.y, tag.uid);
  return s;
}

std::vector<Sentence> leftOutOfTileTags(const Site& site) {
  if (site.looseTags.empty()) return {};
  return {phrase("Core", "Loose tags, which belong to no tile, left out: %1.").with(site.looseTags.size())};
}

std::vector<Sentence> leftOutOfTagPlaces(const Site& site) {
  std::size_t left = 0;
  for (const Tile& tile : site.tiles)
    left += static_cast<std::size_t>(
        std::count_if(tile.uids.begin(), tile.uids.end(), [](const TagUid& uid) { return !uid.empty(); }));
  TagPlaces{site}.forEachRegistered([&left](const TagUid&, Point) { --left; });
  if (left == 0) return {};
  return {phrase("Core", "Registered tags of tiles that are not laid and so have no place, left out: %1.").with(left)};
}

Result<Preview> importTags(const Site& onto, std::string_view csv, const std::string& name) {
  const auto rows = parseCsv(csv, name);
  if (!rows) return tl::unexpected{rows.error()};
  const CsvRow header = rows->empty() ? CsvRow{1, {}} : rows->front();
  const bool tiles = isHeader(header, "serial", "index", "uid");
  const bool places = isHeader(header, "x_m", "y_m", "uid") || isHeader(header, "x", "y", "uid");
  if (!tiles && !places)
    return failure(phrase("Core", "%1: line %2: %3")
                       .with(name, header.line,
                             phrase("Core", "expected the header %1 or %2.").with("serial,index,uid", "x_m,y_m,uid")));
  TableImport import{onto, *rows, name};
  auto site = tiles ? import.tiles() : import.places(onto);
  if (!site) return tl::unexpected{std::move(site.error())};
  Preview preview{std::move(*site), {}, {}};
  preview.changes = sitediff::difference(onto, preview.site);
  if (places && import.onTiles() > 0)
    preview.notes.push_back(
        phrase("Core", "Places where a tile has a tag (within 1 cm), whose UID they give: %1.").with(import.onTiles()));
  return preview;
}

}  // namespace tessera::exchange
