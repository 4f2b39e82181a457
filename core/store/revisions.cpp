#include "store/revisions.h"

#include <utility>

#include "base/sentence.h"
#include "store/revision_parts.h"
#include "store/transaction.h"

namespace tessera::store {
namespace {

constexpr const char* kColumns =
    "SELECT id, saved_ms, who, what, found, laid, moved, taken_up, tags, zones, routes, vehicles, others FROM revision";
constexpr const char* kBytesOfKey =
    "WITH own AS (SELECT floor, picture, rest FROM revision WHERE key=?) SELECT sum(bytes) FROM revision_part"
    " WHERE id IN (SELECT floor FROM own UNION SELECT picture FROM own UNION SELECT rest FROM own)";

struct KeptPart {
  qint64 id = 0;
  QByteArray digest;
};
using KeptParts = std::array<KeptPart, kParts.size()>;

// Which parts the newest revision under this key has; ids 0: there is none.
KeptParts newestParts(Transaction& transaction, const std::string& key) {
  KeptParts parts;
  for (std::size_t n = 0; n < parts.size(); ++n) {
    Statement row{transaction,
                  QStringLiteral("SELECT p.id, p.digest FROM revision r JOIN revision_part p ON p.id=r.%1 WHERE r.key=?"
                                 " ORDER BY r.id DESC LIMIT 1")
                      .arg(QLatin1String{kPartColumns.at(n)})};
    row.run({toText(key)});
    if (row.next()) parts.at(n) = {row.whole(0), row.value(1).toByteArray()};
  }
  return parts;
}

std::optional<floor::Site> readKept(Transaction& transaction, qint64 id) {
  Statement row{transaction, QStringLiteral("SELECT text, digest FROM revision_part WHERE id=?")};
  row.run({id});
  return row.next() ? readPart(row.value(0).toByteArray(), row.value(1).toByteArray()) : std::nullopt;
}

// Gives the number under which the part stands, now or before.
qint64 keepPart(Transaction& transaction, const QByteArray& text, const QByteArray& digest) {
  {
    Statement known{transaction, QStringLiteral("SELECT id FROM revision_part WHERE digest=?")};
    known.run({digest});
    if (known.next()) return known.whole(0);
  }
  const QByteArray packed = compressed(text);
  Statement insert{transaction, QStringLiteral("INSERT INTO revision_part(digest, bytes, text) VALUES(?,?,?)")};
  insert.run({digest, static_cast<qint64>(packed.size()), packed});
  return transaction.failed() ? 0 : insert.lastId();
}

qint64 numberOf(Transaction& transaction, const QString& sql, const std::string& key) {
  Statement row{transaction, sql};
  row.run({toText(key)});
  return row.next() ? row.whole(0) : 0;
}

void thinOut(Transaction& transaction, const std::string& key, const Revisions::Limits& limits) {
  bool thinned = false;
  while (!transaction.failed()) {
    const qint64 count = numberOf(transaction, QStringLiteral("SELECT count(*) FROM revision WHERE key=?"), key);
    const qint64 bytes = numberOf(transaction, QLatin1String{kBytesOfKey}, key);
    if (count <= 2 || (count <= limits.count && bytes <= limits.bytes)) break;
    // Of two that stand close together the later one goes: it is the older state that nobody can make again.
    transaction.run(
        QStringLiteral("DELETE FROM revision WHERE id=(SELECT id FROM (SELECT id, saved_ms - lag(saved_ms) OVER"
                       " (ORDER BY id) AS gap FROM revision WHERE key=? ORDER BY id LIMIT max(2, ?))"
                       " WHERE gap IS NOT NULL ORDER BY gap, id LIMIT 1)"),
        {toText(key), count / 2});
    thinned = true;
  }
  if (thinned)
    transaction.run(
        QStringLiteral("DELETE FROM revision_part WHERE id NOT IN (SELECT floor FROM revision"
                       " UNION SELECT picture FROM revision UNION SELECT rest FROM revision)"));
}

// Nothing where there is something already. The parts are shared, so that it costs a few rows.
void copyRows(Transaction& transaction, const std::string& from, const std::string& to) {
  transaction.run(
      QStringLiteral("INSERT INTO revision(key, saved_ms, who, what, found, floor, picture, rest, laid, moved,"
                     " taken_up, tags, zones, routes, vehicles, others)"
                     " SELECT ?, saved_ms, who, what, found, floor, picture, rest, laid, moved, taken_up,"
                     " tags, zones, routes, vehicles, others FROM revision WHERE key=? AND NOT"
                     " EXISTS(SELECT 1 FROM revision WHERE key=?) ORDER BY id"),
      {toText(to), toText(from), toText(to)});
}

Revision revisionOf(const Statement& row) {
  Revision revision{row.whole(0), {row.whole(1), row.text(2), row.text(3), row.whole(4) != 0}, {}};
  const auto number = [&](int column) { return static_cast<int>(row.whole(column)); };
  if (!row.isNull(5))
    revision.changed =
        sitediff::Tally{number(5), number(6), number(7), number(8), number(9), number(10), number(11), number(12)};
  return revision;
}

}  // namespace

Result<bool> Revisions::add(const std::string& key, const floor::Site& site, const RevisionNote& note) {
  Transaction writing{database_, Transaction::Kind::WriteThrough};
  const KeptParts before = newestParts(writing, key);
  const bool first = before[0].id == 0;
  KeptParts now;
  bool same = !first;
  // Only what differs is read back to count the differences: the rest is empty on both sides.
  floor::Site was;
  floor::Site is;
  bool readable = !first;
  for (const Part part : kParts) {
    const auto n = static_cast<std::size_t>(part);
    floor::Site own = partOf(site, part);
    const QByteArray text = textOf(own);
    now.at(n).digest = digestOf(text);
    if (now.at(n).digest == before.at(n).digest) {
      now.at(n).id = before.at(n).id;
      continue;
    }
    same = false;
    now.at(n).id = keepPart(writing, text, now.at(n).digest);
    auto old = first ? std::nullopt : readKept(writing, before.at(n).id);
    if (!old) readable = false;
    if (!readable) continue;
    putPart(was, part, *std::move(old));
    putPart(is, part, std::move(own));
  }
  if (same) {
    if (auto done = writing.commit(); !done) return tl::unexpected{done.error()};
    return false;
  }
  const sitediff::Tally tally = readable ? sitediff::tallyOf(was, is) : sitediff::Tally{};
  const auto counted = [readable](int count) { return readable ? QVariant{count} : QVariant{}; };
  writing.run(QStringLiteral("INSERT INTO revision(key, saved_ms, who, what, found, floor, picture, rest, laid, moved,"
                             " taken_up, tags, zones, routes, vehicles, others)"
                             " VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)"),
              {toText(key), static_cast<qint64>(note.savedUtcMs), toText(note.who), toText(note.what),
               static_cast<int>(note.found), now[0].id, now[1].id, now[2].id, counted(tally.laid), counted(tally.moved),
               counted(tally.takenUp), counted(tally.tags), counted(tally.zones), counted(tally.routes),
               counted(tally.vehicles), counted(tally.others)});
  thinOut(writing, key, limits_);
  if (auto done = writing.commit(); !done) return tl::unexpected{done.error()};
  return true;
}

Result<void> Revisions::copy(const std::string& from, const std::string& to) {
  Transaction writing{database_, Transaction::Kind::WriteThrough};
  copyRows(writing, from, to);
  return writing.commit();
}

Result<void> Revisions::adopt(const std::string& key, const floor::Site& site) {
  Transaction writing{database_, Transaction::Kind::WriteThrough};
  if (numberOf(writing, QStringLiteral("SELECT count(*) FROM revision WHERE key=?"), key) == 0) {
    std::string from;
    {
      Statement row{writing,
                    QStringLiteral("SELECT r.key FROM revision r JOIN revision_part f ON f.id=r.floor"
                                   " JOIN revision_part p ON p.id=r.picture JOIN revision_part o ON o.id=r.rest"
                                   " WHERE f.digest=? AND p.digest=? AND o.digest=? AND r.id=(SELECT max(id)"
                                   " FROM revision n WHERE n.key=r.key) ORDER BY r.id DESC LIMIT 1")};
      const auto digest = [&](Part part) { return digestOf(textOf(partOf(site, part))); };
      row.run({digest(kParts[0]), digest(kParts[1]), digest(kParts[2])});
      if (row.next()) from = row.text(0);
    }
    if (!from.empty()) copyRows(writing, from, key);
  }
  return writing.commit();
}

Result<std::vector<Revision>> Revisions::list(const std::string& key) const {
  Transaction reading{database_, Transaction::Kind::Read};
  std::vector<Revision> all;
  {
    Statement rows{reading, QLatin1String{kColumns} + QStringLiteral(" WHERE key=? ORDER BY id DESC")};
    rows.run({toText(key)});
    while (rows.next()) all.push_back(revisionOf(rows));
  }
  if (auto done = reading.commit(); !done) return tl::unexpected{done.error()};
  return all;
}

Result<floor::Site> Revisions::load(std::int64_t id) const {
  Transaction reading{database_, Transaction::Kind::Read};
  std::array<qint64, kParts.size()> parts{};
  bool known = false;
  {
    Statement row{reading, QStringLiteral("SELECT floor, picture, rest FROM revision WHERE id=?")};
    row.run({static_cast<qint64>(id)});
    known = row.next();
    for (std::size_t n = 0; known && n < parts.size(); ++n) parts.at(n) = row.whole(static_cast<int>(n));
  }
  floor::Site site;
  bool whole = true;
  for (const Part part : kParts) {
    auto own = known ? readKept(reading, parts.at(static_cast<std::size_t>(part))) : std::nullopt;
    whole = whole && own;
    if (own) putPart(site, part, *std::move(own));
  }
  if (auto done = reading.commit(); !done) return tl::unexpected{done.error()};
  if (!known) return failure(phrase("Core", "This revision is no longer kept: newer ones took its place.").with());
  if (!whole)
    return failure(
        phrase("Core", "%1: this revision is damaged and cannot be read. The others and the site are as they were.")
            .with(database_.path().string()));
  return site;
}

}  // namespace tessera::store
