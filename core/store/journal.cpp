#include "store/journal.h"

#include "store/transaction.h"
#include "store/wording_json.h"

namespace tessera::store {
namespace {

constexpr const char* kInsert =
    "INSERT INTO journal(utc_ms, site, vehicle, severity, kind, over, sentence, pattern, args) "
    "VALUES(?,?,?,?,?,?,?,?,?)";

// Short enough that nobody waits long behind it.
constexpr int kPrunedAtOnce = 20'000;

void insertEntry(Statement& insert, std::int64_t utcMs, const std::string& site, std::optional<VehicleId> vehicle,
                 supervisor::Severity severity, std::string_view kind, bool over, const Sentence& sentence) {
  const Pattern* pattern = sentence.pattern();
  insert.run({static_cast<qint64>(utcMs), toText(site),
              vehicle ? QVariant{static_cast<int>(vehicle->value)} : QVariant{}, static_cast<int>(severity),
              toText(kind), static_cast<int>(over), toText(sentence.english()),
              pattern != nullptr ? QVariant{toText(pattern->english())} : QVariant{},
              pattern != nullptr ? QVariant{argumentsToJson(sentence)} : QVariant{}});
}

}  // namespace

Result<void> Journal::append(std::span<const Note> notes) {
  if (notes.empty()) return {};
  Transaction writing{database_, Transaction::Kind::Write};
  {
    Statement insert{writing, QLatin1String{kInsert}};
    for (const auto& [utcMs, site, event] : notes)
      insertEntry(insert, utcMs, site, event.vehicle, event.severity, supervisor::nameOf(event.kind), event.over,
                  event.sentence);
  }
  return writing.commit();
}

Result<void> Journal::appendLoss(std::uint64_t count, std::int64_t utcMs) {
  Transaction writing{database_, Transaction::Kind::Write};
  {
    Statement insert{writing, QLatin1String{kInsert}};
    insertEntry(
        insert, utcMs, "", std::nullopt, supervisor::Severity::Warning, kEntriesLost, false,
        phrase("Core", "Entries before this one were lost because the journal could not be written: %1.").with(count));
  }
  return writing.commit();
}

Result<std::int64_t> Journal::prune(std::int64_t beforeUtcMs, std::int64_t atMost) {
  std::int64_t removed = 0;
  const auto removeAll = [&](const char* which, std::int64_t bound) -> Result<void> {
    for (int changed = kPrunedAtOnce; changed == kPrunedAtOnce;) {
      Transaction writing{database_, Transaction::Kind::Write};
      {
        Statement remove{writing, QStringLiteral("DELETE FROM journal WHERE id IN (%1 LIMIT %2)")
                                      .arg(QLatin1String{which})
                                      .arg(kPrunedAtOnce)};
        remove.run({static_cast<qint64>(bound)});
        changed = writing.failed() ? 0 : remove.changed();
      }
      if (auto done = writing.commit(); !done) return done;
      removed += changed;
    }
    return {};
  };
  if (auto done = removeAll("SELECT id FROM journal WHERE utc_ms < ? ORDER BY utc_ms", beforeUtcMs); !done)
    return tl::unexpected{done.error()};
  if (auto done = removeAll("SELECT id FROM journal WHERE id <= (SELECT id FROM journal ORDER BY id DESC LIMIT 1"
                            " OFFSET max(?, 0)) ORDER BY id",
                            atMost);
      !done)
    return tl::unexpected{done.error()};
  return removed;
}

}  // namespace tessera::store
