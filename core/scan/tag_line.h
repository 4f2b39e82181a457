// One line of a reader: a tag's UID, and where the tag holds its own place, that too. docs/readers.md states the forms.
#pragma once

#include <optional>
#include <string_view>

#include "base/pose.h"
#include "base/result.h"
#include "floor/tag.h"

namespace tessera::scan {

struct TagRead {
  floor::TagUid uid;
  std::optional<Point> place;  ///< as the tag itself says
  bool operator==(const TagRead&) const = default;
};

enum class LineForm {
  Hex,              ///< 8, 14 or 20 hexadecimal digits, perhaps parted
  Decimal,          ///< the UID as one number, its first byte the highest
  ReversedDecimal,  ///< its first byte the lowest
};

/// The longest line that can be a read; what is longer is none.
inline constexpr std::size_t kLongestLine = 120;

/// line: without its end. Error: a sentence that quotes it.
[[nodiscard]] Result<TagRead> readLine(std::string_view line, LineForm form);

}  // namespace tessera::scan
