#include "store/site_store.h"

#include <QUuid>
#include <map>
#include <system_error>

#include "store/row_sinks.h"

namespace tessera::store {
namespace {

constexpr std::string_view kUnsaved = "unsaved:";
constexpr const char* kKeptSites = "SELECT key, name, saved_ms, differs FROM site ";

using Fingerprints = std::map<std::string, QByteArray, std::less<>>;

Fingerprints fingerprintsOf(Transaction& transaction, qint64 site) {
  Fingerprints all;
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

void writeSections(Transaction& transaction, qint64 id, const floor::Site& site) {
  const Fingerprints old = fingerprintsOf(transaction, id);
  InsertSink inserts{transaction, id};
  forEachSection(site, [&](std::string_view name, const auto& tables, const auto& items) {
    if (transaction.failed()) return;
    FingerprintSink sink;
    rowsOf(items, sink);
    const QByteArray fingerprint = sink.result();
    const auto kept = old.find(name);
    if (kept != old.end() && kept->second == fingerprint) return;
    for (const Table table : tables)
      transaction.run(QStringLiteral("DELETE FROM ") + toText(kTableNames[static_cast<std::size_t>(table)]) +
                          QStringLiteral(" WHERE site=?"),
                      {id});
    rowsOf(items, inserts);
    transaction.run(QStringLiteral("INSERT INTO section VALUES(?,?,?) ON CONFLICT DO UPDATE SET"
                                   " fingerprint=excluded.fingerprint"),
                    {id, toText(name), fingerprint});
  });
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
  writeSections(writing, id, site);
  return writing.commit();
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
