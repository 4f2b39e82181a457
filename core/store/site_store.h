// Sites in the database: the window's working copies. A site is kept under a key: the absolute path of its JSON file,
// or a fresh one while it has no file. Kept and loaded again it is the same site bit by bit.
#pragma once

#include <QByteArray>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "floor/site_map.h"
#include "store/database.h"

namespace tessera::store {

/// What is known of a kept site without loading it.
struct KeptSite {
  std::string key;
  std::string name;
  std::int64_t savedUtcMs = 0;   ///< when it was kept last
  bool differsFromFile = false;  ///< holds edits that its file does not have (or it has no file)
  /// Empty: it was never written to a file.
  [[nodiscard]] std::filesystem::path file() const;
  bool operator==(const KeptSite&) const = default;
};

/// The key of a site with a file: its absolute path without links and dots, so that one file has one key.
[[nodiscard]] std::string keyOfFile(const std::filesystem::path& file);
/// A new key for a site that has no file yet.
[[nodiscard]] std::string freshKey();

/// What one writer wrote last, by which its next saving of the same site finds what has changed since, and writes that
/// alone. The marks stand in the database beside each section: where another has written meanwhile they are others.
struct LastWritten {
  std::string key;
  std::shared_ptr<const floor::SiteMap> map;
  std::map<std::string, QByteArray, std::less<>> marks;
};

class SiteStore {
public:
  explicit SiteStore(Database& database) : database_{database} {}

  /// In one transaction that is on the disk when it returns. Writes the sections (tiles, routes, ...) that differ from
  /// what is kept under this key, and nothing of the others.
  [[nodiscard]] Result<void> save(const std::string& key, const floor::Site& site, std::int64_t utcMs,
                                  bool differsFromFile);
  /// The same, and of the tiles those that have changed since `last`, so that a tag of a large floor is kept at once.
  [[nodiscard]] Result<void> save(const std::string& key, std::shared_ptr<const floor::SiteMap> map, std::int64_t utcMs,
                                  bool differsFromFile, LastWritten& last);
  /// The site now stands in its file as well, or no longer.
  [[nodiscard]] Result<void> setDiffers(const std::string& key, bool differsFromFile);
  /// The site goes on under another key, e.g. after it was saved under another name. What was kept there is replaced.
  [[nodiscard]] Result<void> rename(const std::string& from, const std::string& to);
  [[nodiscard]] Result<void> remove(const std::string& key);

  /// Nullopt: nothing is kept under this key.
  [[nodiscard]] Result<std::optional<floor::Site>> load(const std::string& key) const;
  [[nodiscard]] Result<std::optional<KeptSite>> find(const std::string& key) const;
  /// All, the latest first.
  [[nodiscard]] Result<std::vector<KeptSite>> list() const;

private:
  Database& database_;
};

}  // namespace tessera::store
