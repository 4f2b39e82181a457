// Finding entries of the journal again.
#include <algorithm>
#include <vector>

#include "store/journal.h"
#include "store/transaction.h"
#include "store/wording_json.h"

namespace tessera::store {
namespace {

JournalEntry entryOf(const Statement& row) {
  JournalEntry entry;
  entry.id = row.whole(0);
  entry.utcMs = row.whole(1);
  entry.site = row.text(2);
  if (!row.isNull(3)) entry.vehicle = VehicleId{static_cast<std::uint8_t>(row.whole(3))};
  entry.severity = static_cast<supervisor::Severity>(std::clamp<qint64>(row.whole(4), 0, 2));
  entry.kind = row.text(5);
  entry.over = row.whole(6) != 0;
  entry.sentence = row.text(7);
  if (row.isNull(8))
    entry.wording.text = entry.sentence;
  else
    entry.wording = {row.text(8), true, argumentsFromJson(row.value(9).toByteArray())};
  return entry;
}

}  // namespace

Result<JournalPage> Journal::query(const JournalFilter& filter) const {
  // By id, not by time: pages do not shift when somebody sets the clock.
  QString sql = QStringLiteral(
      "SELECT id, utc_ms, site, vehicle, severity, kind, over, sentence, pattern, args FROM journal WHERE id < ?");
  std::vector<QVariant> values{static_cast<qint64>(filter.beforeId)};
  const auto require = [&](const char* condition, const QVariant& value) {
    sql += QStringLiteral(" AND ") + QLatin1String{condition};
    values.push_back(value);
  };
  if (filter.fromUtcMs) require("utc_ms >= ?", static_cast<qint64>(*filter.fromUtcMs));
  if (filter.untilUtcMs) require("utc_ms < ?", static_cast<qint64>(*filter.untilUtcMs));
  if (filter.vehicle) require("vehicle = ?", static_cast<int>(filter.vehicle->value));
  if (filter.site) require("site = ?", toText(*filter.site));
  if (filter.atLeast != supervisor::Severity::Info) require("severity >= ?", static_cast<int>(filter.atLeast));
  if (!filter.text.empty()) require("instr(lower(sentence), lower(?)) > 0", toText(filter.text));
  sql += QStringLiteral(" ORDER BY id DESC LIMIT ?");
  // One more than asked for tells whether there are more.
  const auto limit = static_cast<std::size_t>(std::clamp(filter.limit, 1, 100'000));
  values.emplace_back(static_cast<qint64>(limit + 1));

  Transaction reading{database_, Transaction::Kind::Read};
  JournalPage page;
  {
    Statement rows{reading, sql};
    rows.run(values);
    while (rows.next()) page.entries.push_back(entryOf(rows));
  }
  if (auto done = reading.commit(); !done) return tl::unexpected{done.error()};
  page.more = page.entries.size() > limit;
  if (page.more) page.entries.resize(limit);
  return page;
}

}  // namespace tessera::store
