// A folder of its own for each test, a database in it, and values to put there.
#pragma once

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "store/database.h"
#include "store/journal_entry.h"

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
