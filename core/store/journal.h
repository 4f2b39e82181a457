// What happened, kept for later: events with the wall clock's time, in the order in which they came.
#pragma once

#include <cstdint>
#include <span>

#include "store/database.h"
#include "store/journal_entry.h"

namespace tessera::store {

class Journal {
public:
  explicit Journal(Database& database) : database_{database} {}

  /// All or none, in one transaction. Written they survive the end of the program, however it ends.
  [[nodiscard]] Result<void> append(std::span<const Note> notes);
  /// Tells in the journal itself that `count` entries before this one were lost.
  [[nodiscard]] Result<void> appendLoss(std::uint64_t count, std::int64_t utcMs);
  [[nodiscard]] Result<JournalPage> query(const JournalFilter& filter) const;
  /// Removes what is older than `beforeUtcMs`, and the oldest of what is more than `atMost`. Gives the number removed.
  [[nodiscard]] Result<std::int64_t> prune(std::int64_t beforeUtcMs, std::int64_t atMost);

private:
  Database& database_;
};

}  // namespace tessera::store
