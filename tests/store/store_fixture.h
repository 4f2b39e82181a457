// A folder of its own for each test, a database in it, and values to put there.
#pragma once

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "store/database.h"
#include "store/journal_entry.h"
#include "store/migrations.h"
#include "store/transaction.h"

namespace tessera::store::test {

class StoreTest : public testing::Test {
protected:
  [[nodiscard]] std::filesystem::path file() const { return folder() / "tessera.db"; }
  [[nodiscard]] std::filesystem::path folder() const { return folder_.path().toStdString(); }
  [[nodiscard]] std::unique_ptr<Database> open(const Database::Options& options = {}) const {
    auto database = Database::open(file(), options);
    if (!database) ADD_FAILURE() << database.error().sentence;
    return database ? std::move(*database) : nullptr;
  }
  /// The sentence with which opening fails; empty when it does not.
  [[nodiscard]] std::string refusal(const Database::Options& options = {}) const {
    const auto database = Database::open(file(), options);
    return database ? "" : database.error().sentence;
  }
  /// As if made by the program that knew no step of the layout after `version`.
  void backTo(int version, const char* more = nullptr) const {
    const std::vector<std::vector<const char*>> undone{
        {"DROP TABLE journal"},
        {"DROP TABLE backdrop", "DROP TABLE backdrop_picture", "DELETE FROM section WHERE name LIKE 'backdrop%'"},
        {"DROP TABLE revision", "DROP TABLE revision_part"},
        {"ALTER TABLE route_vertex DROP COLUMN leg_speed"},
        {"DROP TABLE magnetic_map"},
        {"ALTER TABLE vehicle DROP COLUMN corner_cut"}};
    auto database = open();
    ASSERT_EQ(static_cast<int>(undone.size()) + 1, newestVersion()) << "a step that this does not take back";
    Transaction writing{*database, Transaction::Kind::Write};
    for (int step = newestVersion(); step > version; --step) {
      for (const char* sql : undone.at(static_cast<std::size_t>(step) - 2)) writing.run(QLatin1String{sql});
    }
    writing.run(QStringLiteral("DELETE FROM schema_version WHERE version > ?"), {version});
    if (more != nullptr) writing.run(QLatin1String{more});
    ASSERT_TRUE(writing.commit());
  }
  static std::string bytesOf(const std::filesystem::path& path) {
    std::ifstream in{path, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
  }
  static void write(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream{path, std::ios::binary} << bytes;
  }

private:
  QTemporaryDir folder_;
};

inline Note note(std::int64_t utcMs, const std::string& sentence,
                 supervisor::Severity severity = supervisor::Severity::Info, std::optional<VehicleId> vehicle = {}) {
  Note n{utcMs, "Hall", {}};
  n.event.sentence = sentence;
  n.event.severity = severity;
  n.event.vehicle = vehicle;
  n.event.kind = supervisor::EventKind::RouteStarted;
  return n;
}

}  // namespace tessera::store::test
