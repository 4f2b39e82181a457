// What the journal takes and gives, as plain values.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "supervisor/event.h"

namespace tessera::store {

/// One event as it is handed to the journal.
struct Note {
  std::int64_t utcMs = 0;  ///< milliseconds since 1970, UTC
  std::string site;        ///< the site's name
  supervisor::Event event;
  bool operator==(const Note&) const = default;
};

/// A Sentence as it comes back from the disk: the pattern is looked up by its text.
struct Wording {
  std::string text;  ///< a pattern with %1 to %9 for `arguments`, else a text that is shown as it is
  bool isPattern = false;
  std::vector<Wording> arguments;
  bool operator==(const Wording&) const = default;
};

/// One line of the journal.
struct JournalEntry {
  std::int64_t id = 0;  ///< grows from entry to entry
  std::int64_t utcMs = 0;
  std::string site;
  std::optional<VehicleId> vehicle;
  supervisor::Severity severity = supervisor::Severity::Info;
  std::string kind;  ///< supervisor::nameOf(EventKind), or kEntriesLost
  bool over = false;
  std::string sentence;  ///< English
  Wording wording;       ///< what the sentence was made of, to say it in another language
  bool operator==(const JournalEntry&) const = default;
};

/// The kind of an entry that the journal wrote itself, because entries before it were lost.
inline constexpr const char* kEntriesLost = "entries-lost";

struct JournalFilter {
  std::optional<std::int64_t> fromUtcMs{};   ///< from this instant on
  std::optional<std::int64_t> untilUtcMs{};  ///< before this instant
  std::optional<VehicleId> vehicle{};
  std::optional<std::string> site{};
  supervisor::Severity atLeast = supervisor::Severity::Info;
  std::string text{};  ///< somewhere in the sentence; A to Z match a to z
  /// For the next page: the id of the last entry of this one.
  std::int64_t beforeId = std::numeric_limits<std::int64_t>::max();
  int limit = 200;
};

struct JournalPage {
  std::vector<JournalEntry> entries;  ///< newest first
  bool more = false;                  ///< older ones match as well
};

}  // namespace tessera::store
