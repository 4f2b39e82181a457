// One SQLite file through Qt Sql: opened or made, checked, and brought to the layout that this program knows.
// A Database belongs to the thread that opened it.
#pragma once

#include <QSqlDatabase>
#include <QSqlError>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

#include "base/result.h"

namespace tessera::store {

/// Of the SQLite library that runs, "3.40.1"; empty: there is no driver for it.
[[nodiscard]] std::string sqliteVersion();

class Database {
public:
  struct Options {
    std::chrono::milliseconds busyTimeout{2000};  ///< how long to wait for another program that writes
    int maxPages = 0;                             ///< the file grows no further (0: as far as the disk goes)
    bool writeAheadLog = true;                    ///< false: a rollback journal; for comparison only
  };

  /// Makes the file when there is none, readable by its owner alone, as it holds the vehicles' keys.
  /// Error: a folder or file that cannot be used, a damaged file, one of another program or of a newer version of this
  /// one. Such a file is left as it is.
  [[nodiscard]] static Result<std::unique_ptr<Database>> open(const std::filesystem::path& path, Options options);
  [[nodiscard]] static Result<std::unique_ptr<Database>> open(const std::filesystem::path& path) {
    return open(path, Options{});
  }
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
  friend class Transaction;
  friend class Statement;
  explicit Database(std::filesystem::path path);
  [[nodiscard]] Result<void> connect(const Options& options);
  [[nodiscard]] Result<void> check();
  [[nodiscard]] Result<void> configure(const Options& options);
  /// What went wrong, as a sentence that says what to do.
  [[nodiscard]] Error explain(const QSqlError& error) const;
  [[nodiscard]] Error damaged() const;

  std::filesystem::path path_;
  QSqlDatabase connection_;
  bool full_ = false;  // PRAGMA synchronous=FULL is set, else NORMAL
};

}  // namespace tessera::store
