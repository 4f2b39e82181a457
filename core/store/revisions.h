// What a site was each time it was saved: who, when, what, and the site itself. Revisions belong to the file that was
// saved; a site that has none yet has no revisions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "floor/site.h"
#include "sitediff/tally.h"
#include "store/database.h"
#include "store/revision_note.h"

namespace tessera::store {

struct Revision {
  std::int64_t id = 0;
  RevisionNote note;
  /// What this saving changed. nullopt: it is the first, or the one before it cannot be read.
  std::optional<sitediff::Tally> changed;
  bool operator==(const Revision&) const = default;
};

class Revisions {
public:
  struct Limits {
    int count = 200;                           ///< of one site
    std::int64_t bytes = 256LL * 1024 * 1024;  ///< of one site, compressed
  };
  Revisions(Database& database, Limits limits) : database_{database}, limits_{limits} {}
  explicit Revisions(Database& database) : Revisions{database, Limits{}} {}

  /// Whole or not at all, and on the disk when it returns. False: it is the same as the newest, and nothing is added.
  /// key: as in SiteStore. Beyond the limits those of the older half go that stand nearest to the one before them,
  /// never the first and never the newest: the past grows coarser, it has no end.
  [[nodiscard]] Result<bool> add(const std::string& key, const floor::Site& site, const RevisionNote& note);
  /// Where nothing is kept under `to`, all that is kept under `from` is from now on kept there as well: the file went
  /// on under another name. What stands in a file that is written over keeps its own past.
  [[nodiscard]] Result<void> copy(const std::string& from, const std::string& to);
  /// For a file that was opened: where nothing is kept under its key, and it is what the newest revision of another one
  /// is, it is that one moved or copied, and takes its past along.
  [[nodiscard]] Result<void> adopt(const std::string& key, const floor::Site& site);
  /// The newest first.
  [[nodiscard]] Result<std::vector<Revision>> list(const std::string& key) const;
  /// The site as its file would give it. Error: it is damaged, or no longer kept.
  [[nodiscard]] Result<floor::Site> load(std::int64_t id) const;

private:
  Database& database_;
  Limits limits_;
};

}  // namespace tessera::store
