// A transaction that remembers its first failure: whatever follows it is left out, and commit() tells it. So a long
// list of statements needs one question at its end.
#pragma once

#include <QSqlQuery>
#include <QString>
#include <QVariant>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "store/database.h"

namespace tessera::store {

class Transaction {
public:
  enum class Kind {
    Read,
    Write,         ///< survives the end of the program at once, a power cut after some seconds
    WriteThrough,  ///< survives a power cut as well, for the price of waiting for the disk
  };

  Transaction(Database& database, Kind kind);
  /// Takes everything back unless it was committed.
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void run(const QString& sql, std::initializer_list<QVariant> values = {});
  /// Error: the first thing that failed; then nothing has changed.
  [[nodiscard]] Result<void> commit();

  [[nodiscard]] bool failed() const { return error_.has_value(); }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  /// The first failure counts.
  void fail(Error error);
  /// The file holds what this program never wrote.
  void failDamaged() { fail(database_.damaged()); }

private:
  friend class Statement;
  Database& database_;
  std::optional<Error> error_;
  bool open_ = false;
};

/// One prepared statement, run as often as wanted.
class Statement {
public:
  Statement(Transaction& transaction, const QString& sql);

  void run(std::span<const QVariant> values);
  void run(std::initializer_list<QVariant> values = {}) { run(std::span{values.begin(), values.size()}); }
  /// The next row of a SELECT; false: there is none, or something failed.
  [[nodiscard]] bool next();
  [[nodiscard]] QVariant value(int column) const { return query_.value(column); }
  [[nodiscard]] bool isNull(int column) const { return query_.isNull(column); }
  [[nodiscard]] qint64 whole(int column) const { return query_.value(column).toLongLong(); }
  [[nodiscard]] double number(int column) const { return query_.value(column).toDouble(); }
  /// A text, or bytes that stand for one.
  [[nodiscard]] std::string text(int column) const {
    const QVariant value = query_.value(column);
    return value.typeId() == QMetaType::QByteArray ? value.toByteArray().toStdString() : value.toString().toStdString();
  }
  /// Rows that the last run changed.
  [[nodiscard]] int changed() const { return query_.numRowsAffected(); }
  [[nodiscard]] qint64 lastId() const { return query_.lastInsertId().toLongLong(); }

private:
  Transaction& transaction_;
  QSqlQuery query_;
};

[[nodiscard]] inline QString toText(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

}  // namespace tessera::store
