#include "store/site_store.h"

#include <QUuid>
#include <algorithm>
#include <any>
#include <map>
#include <system_error>
#include <type_traits>
#include <utility>

#include "store/row_sinks.h"

namespace tessera::store {
namespace {

constexpr std::string_view kUnsaved = "unsaved:";
constexpr std::size_t kChangedShare = 32;  // of a section: beyond that it is quicker written whole
constexpr const char* kKeptSites = "SELECT key, name, saved_ms, differs FROM site ";

using Marks = decltype(LastWritten::marks);

// Fingerprints, or for what was changed in part, names that nothing else has.
Marks marksOf(Transaction& transaction, qint64 site) {
  Marks all;
  Statement sections{transaction, QStringLiteral("SELECT name, fingerprint FROM section WHERE site=?")};
  sections.run({site});
  while (sections.next()) all[sections.text(0)] = sections.value(1).toByteArray();
  return all;
}

/// Writes what stands in `site` itself; gives its number.
qint64 writeHead(Transaction& transaction, const std::string& key, const floor::Site& site, std::int64_t utcMs,
                 bool differs) {
  Statement head{transaction,
                 QStringLiteral("INSERT INTO site(key, name, saved_ms, differs, north_to_y, channel, air_rate, baud)"
                                " VALUES(?,?,?,?,?,?,?,?) ON CONFLICT(key) DO UPDATE SET name=excluded.name,"
                                " saved_ms=excluded.saved_ms, differs=excluded.differs, north_to_y=excluded.north_to_y,"
                                " channel=excluded.channel, air_rate=excluded.air_rate, baud=excluded.baud"
                                " RETURNING id")};
  const auto& [channel, airRate, baud] = site.radio;
  head.run({toText(key), keptText(transaction, site.name), static_cast<qint64>(utcMs), static_cast<int>(differs),
            site.northToY.value(), channel, airRate, baud});
  return head.next() ? head.whole(0) : 0;
}

/// A site's sections by their names, as pointers to them; a picture goes by where its bytes lie.
using Sections = std::map<std::string_view, std::any>;
template <class Items>
std::any sectionOf(const Items& items) {
  return &items;
}
std::any sectionOf(const PictureBytes& picture) { return picture; }

Sections sectionsOf(const floor::Site& site) {
  Sections all;
  forEachSection(site, [&](std::string_view name, const auto&, const auto& items) { all[name] = sectionOf(items); });
  return all;
}

// Zeros of both signs are one: who reads the section back has the same site.
template <class Items>
bool same(const std::any& before, const Items& now) {
  return *std::any_cast<const Items*>(before) == now;
}
bool same(const std::any& before, const PictureBytes& now) {
  const auto was = std::any_cast<PictureBytes>(before).bytes;
  return was.data() == now.bytes.data() && was.size() == now.bytes.size();
}

void removeRows(Transaction& transaction, qint64 id, Table table, const char* column, std::size_t number) {
  transaction.run(QStringLiteral("DELETE FROM %1 WHERE site=? AND %2=?")
                      .arg(toText(kTableNames[static_cast<std::size_t>(table)]), QLatin1String{column}),
                  {id, static_cast<qint64>(number)});
}
void removeOne(Transaction& transaction, qint64 id, const floor::Tile&, std::size_t number) {
  removeRows(transaction, id, Table::Tag, "tile", number);
  removeRows(transaction, id, Table::Tile, "nr", number);
}
void removeOne(Transaction& transaction, qint64 id, const floor::Placement&, std::size_t number) {
  removeRows(transaction, id, Table::Placement, "nr", number);
}

/// False: the section is better written whole.
template <class Items>
bool writeChanged(Transaction&, qint64, const std::any&, const Items&, InsertSink&) {
  return false;
}
template <class Item>
requires(std::is_same_v<Item, floor::Tile> || std::is_same_v<Item, floor::Placement>) bool writeChanged(
    Transaction& transaction, qint64 id, const std::any& known, const std::vector<Item>& now, InsertSink& inserts) {
  const auto& before = *std::any_cast<const std::vector<Item>*>(known);
  const std::size_t most = now.size() / kChangedShare;
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < std::max(before.size(), now.size()); ++i) {
    if (i < before.size() && i < now.size() && before[i] == now[i]) continue;
    if (changed.size() == most) return false;
    changed.push_back(i);
  }
  for (const std::size_t i : changed) {
    if (i < before.size()) removeOne(transaction, id, before[i], i);
    if (i < now.size()) rowsOfOne(now[i], i, inserts);
  }
  return true;
}

/// Gives the marks that stand beside the sections then.
Marks writeSections(Transaction& transaction, qint64 id, const floor::Site& site, const floor::Site* before,
                    const Marks& marks) {
  Marks all = marksOf(transaction, id);
  const Sections known = before != nullptr ? sectionsOf(*before) : Sections{};
  InsertSink inserts{transaction, id};
  forEachSection(site, [&](std::string_view name, const auto& tables, const auto& items) {
    if (transaction.failed()) return;
    const auto kept = all.find(name);
    const auto own = marks.find(name);
    // Nobody else has written: what was written last is what stands there.
    const bool isKnown = before != nullptr && kept != all.end() && own != marks.end() && kept->second == own->second;
    if (isKnown && same(known.at(name), items)) return;
    QByteArray mark;
    if (isKnown && writeChanged(transaction, id, known.at(name), items, inserts)) {
      mark = QUuid::createUuid().toRfc4122();  // no fingerprint: whoever knows nothing of it writes the section anew
    } else {
      FingerprintSink sink;
      rowsOf(items, sink);
      mark = sink.result();
      if (kept != all.end() && kept->second == mark) return;
      for (const Table table : tables)
        transaction.run(QStringLiteral("DELETE FROM ") + toText(kTableNames[static_cast<std::size_t>(table)]) +
                            QStringLiteral(" WHERE site=?"),
                        {id});
      rowsOf(items, inserts);
    }
    transaction.run(QStringLiteral("INSERT INTO section VALUES(?,?,?) ON CONFLICT DO UPDATE SET"
                                   " fingerprint=excluded.fingerprint"),
                    {id, toText(name), mark});
    all.insert_or_assign(std::string{name}, mark);
  });
  return all;
}

KeptSite keptSite(const Statement& row) { return {row.text(0), row.text(1), row.whole(2), row.whole(3) != 0}; }

}  // namespace

std::filesystem::path KeptSite::file() const {
  return key.starts_with(kUnsaved) ? std::filesystem::path{} : std::filesystem::path{key};
}

std::string keyOfFile(const std::filesystem::path& file) {
  std::error_code error;
  const auto absolute = std::filesystem::absolute(file, error);
  const auto plain = std::filesystem::weakly_canonical(absolute, error);
  return error ? absolute.lexically_normal().string() : plain.string();
}

std::string freshKey() {
  return std::string{kUnsaved} + QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
}

Result<void> SiteStore::save(const std::string& key, const floor::Site& site, std::int64_t utcMs,
                             bool differsFromFile) {
  Transaction writing{database_, Transaction::Kind::WriteThrough};
  const qint64 id = writeHead(writing, key, site, utcMs, differsFromFile);
  writeSections(writing, id, site, nullptr, {});
  return writing.commit();
}

Result<void> SiteStore::save(const std::string& key, std::shared_ptr<const floor::SiteMap> map, std::int64_t utcMs,
                             bool differsFromFile, LastWritten& last) {
  // Until all of it is on the disk, nothing is known of what is there.
  const LastWritten before = std::exchange(last, {});
  Transaction writing{database_, Transaction::Kind::WriteThrough};
  const qint64 id = writeHead(writing, key, map->site(), utcMs, differsFromFile);
  const bool known = before.key == key && before.map;
  Marks marks = writeSections(writing, id, map->site(), known ? &before.map->site() : nullptr, before.marks);
  if (auto done = writing.commit(); !done) return done;
  last = {key, std::move(map), std::move(marks)};
  return {};
}

Result<void> SiteStore::setDiffers(const std::string& key, bool differsFromFile) {
  Transaction writing{database_, Transaction::Kind::WriteThrough};
  writing.run(QStringLiteral("UPDATE site SET differs=? WHERE key=?"),
              {static_cast<int>(differsFromFile), toText(key)});
  return writing.commit();
}

Result<void> SiteStore::rename(const std::string& from, const std::string& to) {
  if (from == to) return {};
  Transaction writing{database_, Transaction::Kind::WriteThrough};
  // Only if there is something to move: otherwise what stands at the goal stays.
  writing.run(QStringLiteral("DELETE FROM site WHERE key=?1 AND EXISTS(SELECT 1 FROM site WHERE key=?2)"),
              {toText(to), toText(from)});
  writing.run(QStringLiteral("UPDATE site SET key=? WHERE key=?"), {toText(to), toText(from)});
  return writing.commit();
}

Result<void> SiteStore::remove(const std::string& key) {
  Transaction writing{database_, Transaction::Kind::WriteThrough};
  writing.run(QStringLiteral("DELETE FROM site WHERE key=?"), {toText(key)});
  return writing.commit();
}

Result<std::optional<KeptSite>> SiteStore::find(const std::string& key) const {
  Transaction reading{database_, Transaction::Kind::Read};
  std::optional<KeptSite> found;
  {
    Statement rows{reading, QLatin1String{kKeptSites} + QStringLiteral("WHERE key=?")};
    rows.run({toText(key)});
    if (rows.next()) found = keptSite(rows);
  }
  if (auto done = reading.commit(); !done) return tl::unexpected{done.error()};
  return found;
}

Result<std::vector<KeptSite>> SiteStore::list() const {
  Transaction reading{database_, Transaction::Kind::Read};
  std::vector<KeptSite> all;
  Statement rows{reading, QLatin1String{kKeptSites} + QStringLiteral("ORDER BY saved_ms DESC, id DESC")};
  rows.run();
  while (rows.next()) all.push_back(keptSite(rows));
  if (auto done = reading.commit(); !done) return tl::unexpected{done.error()};
  return all;
}

}  // namespace tessera::store
