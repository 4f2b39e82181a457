#include "store/transaction.h"

namespace tessera::store {

Transaction::Transaction(Database& database, Kind kind) : database_{database} {
  const bool full = kind == Kind::WriteThrough;
  if (kind != Kind::Read && full != database.full_) {
    // Between transactions only; within one SQLite refuses it.
    run(full ? QStringLiteral("PRAGMA synchronous=FULL") : QStringLiteral("PRAGMA synchronous=NORMAL"));
    database.full_ = full;
  }
  // Immediate: who means to write waits for the other writer now, not halfway through.
  run(kind == Kind::Read ? QStringLiteral("BEGIN") : QStringLiteral("BEGIN IMMEDIATE"));
  open_ = !failed();
}

Transaction::~Transaction() {
  if (!open_) return;
  QSqlQuery query{database_.connection_};
  // Fails where SQLite has taken it back by itself, e.g. on a full disk.
  query.exec(QStringLiteral("ROLLBACK"));
}

void Transaction::run(const QString& sql, std::initializer_list<QVariant> values) { Statement{*this, sql}.run(values); }

Result<void> Transaction::commit() {
  run(QStringLiteral("COMMIT"));
  if (failed()) return tl::unexpected{*error_};
  open_ = false;
  return {};
}

void Transaction::fail(Error error) {
  if (!error_) error_ = std::move(error);
}

Statement::Statement(Transaction& transaction, const QString& sql)
    : transaction_{transaction}, query_{transaction.database_.connection_} {
  query_.setForwardOnly(true);
  if (!transaction_.failed() && !query_.prepare(sql))
    transaction_.fail(transaction_.database_.explain(query_.lastError()));
}

void Statement::run(std::span<const QVariant> values) {
  if (transaction_.failed()) return;
  int at = 0;
  for (const QVariant& value : values) query_.bindValue(at++, value);
  if (!query_.exec()) transaction_.fail(transaction_.database_.explain(query_.lastError()));
}

bool Statement::next() {
  if (transaction_.failed()) return false;
  if (query_.next()) return true;
  // The end of the rows, or an error on the way to the next one.
  if (query_.lastError().isValid()) transaction_.fail(transaction_.database_.explain(query_.lastError()));
  return false;
}

}  // namespace tessera::store
