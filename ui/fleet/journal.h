// What a panel asks of the journal of earlier days, and how the answer comes: page by page, the newest first.
#pragma once

#include <QDate>
#include <QDateTime>
#include <optional>
#include <variant>

#include "base/ids.h"
#include "base/sentence.h"
#include "supervisor/event.h"

namespace tessera::ui {

/// A line that was written in an earlier run of the program, or earlier in this one.
struct JournalLine {
  QDateTime when;
  supervisor::Severity severity = supervisor::Severity::Info;
  std::optional<VehicleId> vehicle;
  std::variant<QString, Sentence> sentence;  ///< as it was shown, or so that it can be shown in any language
};

/// One day of the journal.
struct JournalDay {
  QDate day;
  supervisor::Severity least = supervisor::Severity::Info;
  std::optional<VehicleId> vehicle;  ///< nullopt: all
};

enum class JournalPart {
  Page,     ///< earlier ones follow
  Last,     ///< the day is whole
  TooMany,  ///< there are earlier ones, which do not follow
};

}  // namespace tessera::ui
