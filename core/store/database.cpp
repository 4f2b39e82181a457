#include "store/database.h"

#include <QFile>
#include <QSqlQuery>
#include <QUuid>
#include <QVariant>
#include <system_error>

#include "base/sentence.h"
#include "store/migrations.h"

namespace tessera::store {
namespace {

namespace fs = std::filesystem;

constexpr auto kOwnerOnly = QFileDevice::ReadOwner | QFileDevice::WriteOwner;

// SQLite's result codes (sqlite3.h), without the extension in the upper bits.
enum SqliteCode : int {
  kBusy = 5,
  kLocked = 6,
  kReadOnly = 8,
  kIoError = 10,
  kCorrupt = 11,
  kFull = 13,
  kCantOpen = 14,
  kTooBig = 18,
  kNotADatabase = 26
};

QString qtPath(const fs::path& path) { return QString::fromStdString(path.string()); }

// An empty file with the right permissions, before SQLite makes one with those of the umask. The files beside it
// (-wal, -shm) take the permissions of this one.
Result<void> makeFile(const fs::path& path) {
  std::error_code error;
  if (const fs::path folder = path.parent_path(); !folder.empty()) fs::create_directories(folder, error);
  if (error)
    return failure(
        phrase("Core", "%1: the folder cannot be made: %2.").with(path.parent_path().string(), error.message()));
  QFile file{qtPath(path)};
  if (file.exists()) {
    // A file that others may read, e.g. from a copy: closed to them. One that belongs to somebody else fails later.
    if (!fs::is_directory(path, error)) file.setPermissions(kOwnerOnly);
    return {};
  }
  // Another copy of the program may make it at this very moment: that is as good.
  if (!file.open(QIODevice::WriteOnly | QIODevice::NewOnly, kOwnerOnly) && !file.exists())
    return failure(phrase("Core", "%1: cannot be made: %2. Check the folder's permissions and the space on its disk.")
                       .with(path.string(), file.errorString().toStdString()));
  return {};
}

}  // namespace

Database::Database(fs::path path) : path_{std::move(path)} {}

Database::~Database() {
  if (!connection_.isValid()) return;
  const QString name = connection_.connectionName();
  connection_.close();
  connection_ = QSqlDatabase{};  // Qt wants no copy of it left
  QSqlDatabase::removeDatabase(name);
}

Result<std::unique_ptr<Database>> Database::open(const fs::path& path, Options options) {
  std::unique_ptr<Database> database{new Database{path}};
  if (auto made = makeFile(path); !made) return tl::unexpected{made.error()};
  // Everything that only reads comes first: a file that is refused has not been written to.
  const auto version = database->connect(options).and_then([&] { return database->check(); }).and_then([&] {
    return checkVersion(*database);
  });
  if (!version) return tl::unexpected{version.error()};
  const auto ready = database->configure(options).and_then([&] { return migrate(*database, *version); });
  if (!ready) return tl::unexpected{ready.error()};
  return database;
}

Result<void> Database::connect(const Options& options) {
  if (!QSqlDatabase::isDriverAvailable(QStringLiteral("QSQLITE")))
    return failure(
        phrase("Core", "Qt's driver for SQLite is missing: please install the package libqt6sql6-sqlite.").with());
  connection_ = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QUuid::createUuid().toString());
  connection_.setDatabaseName(qtPath(path_));
  connection_.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=%1").arg(options.busyTimeout.count()));
  if (!connection_.open()) return tl::unexpected{explain(connection_.lastError())};
  return {};
}

Result<void> Database::check() {
  // The pages' structure, not the indices' contents: half a second for a million tags.
  QSqlQuery query{connection_};
  if (!query.exec(QStringLiteral("PRAGMA quick_check(1)")) || !query.next())
    return tl::unexpected{explain(query.lastError())};
  if (query.value(0).toString() != QStringLiteral("ok")) return tl::unexpected{damaged()};
  return {};
}

Result<void> Database::configure(const Options& options) {
  QSqlQuery query{connection_};
  const auto run = [&](const QString& sql) -> Result<void> {
    if (!query.exec(sql)) return tl::unexpected{explain(query.lastError())};
    query.finish();
    return {};
  };
  // On a network drive SQLite refuses the log and keeps its rollback journal; that works too.
  auto result = run(options.writeAheadLog ? QStringLiteral("PRAGMA journal_mode=WAL")
                                          : QStringLiteral("PRAGMA journal_mode=DELETE"))
                    .and_then([&] { return run(QStringLiteral("PRAGMA synchronous=NORMAL")); })
                    .and_then([&] { return run(QStringLiteral("PRAGMA foreign_keys=ON")); })
                    // What a large save left of the log is given back to the disk.
                    .and_then([&] { return run(QStringLiteral("PRAGMA journal_size_limit=4194304")); });
  if (result && options.maxPages > 0) result = run(QStringLiteral("PRAGMA max_page_count=%1").arg(options.maxPages));
  return result;
}

Error Database::damaged() const {
  return {
      phrase("Core", "%1: the file is damaged. It was left as it is: keep a copy, then move it away and start anew.")
          .with(path_.string())};
}

Error Database::explain(const QSqlError& error) const {
  const auto sentence = [this](Pattern pattern) { return Error{pattern.with(path_.string())}; };
  switch (error.nativeErrorCode().toInt() & 0xFF) {
    case kBusy:
    case kLocked:
      return sentence(phrase("Core", "%1: another program is writing to this file. Close the other copy of Tessera."));
    case kReadOnly:
      return sentence(phrase("Core", "%1: cannot be written to. Check the permissions of the file and of its folder."));
    case kFull:
      return sentence(phrase("Core", "%1: the disk is full. Make room on it."));
    case kIoError:
      return sentence(
          phrase("Core", "%1: the disk failed to read or write. Check that it is still there and has room."));
    case kCantOpen:
      return sentence(phrase("Core", "%1: cannot be opened. Check the permissions of the file and of its folder."));
    case kCorrupt:
      return damaged();
    case kNotADatabase:
      return sentence(
          phrase("Core", "%1: is no file of Tessera's. It was left as it is: move it away or choose another place."));
    case kTooBig:
      return sentence(phrase("Core", "%1: a value is too large to be kept."));
    default:
      return {phrase("Core", "%1: cannot be used: %2.").with(path_.string(), error.databaseText().toStdString())};
  }
}

std::string sqliteVersion() {
  const QString name = QStringLiteral("tessera-version");
  std::string version;
  {
    QSqlDatabase memory = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), name);
    memory.setDatabaseName(QStringLiteral(":memory:"));
    QSqlQuery query{memory};
    if (memory.open() && query.exec(QStringLiteral("SELECT sqlite_version()")) && query.next())
      version = query.value(0).toString().toStdString();
  }
  QSqlDatabase::removeDatabase(name);
  return version;
}

}  // namespace tessera::store
