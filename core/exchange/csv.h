// Tables of comma-separated values (RFC 4180), as spreadsheets write them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace tessera::exchange {

struct CsvRow {
  std::size_t line = 0;  ///< on which it begins, from 1
  std::vector<std::string> fields;
  bool operator==(const CsvRow&) const = default;
};

/// Lines end with LF or CRLF; a byte order mark before the first is passed over, as are empty lines. Fields may stand
/// in quotes, with "" for a quote within, and then hold commas and line ends. Error: names `name` (the file) and the
/// line: quotes that are not closed or stand within a bare field, text after a closing quote, a row of another length
/// than the first, more than 64 MiB.
[[nodiscard]] Result<std::vector<CsvRow>> parseCsv(std::string_view text, const std::string& name);

/// Quoted where it has to be.
[[nodiscard]] std::string csvField(std::string_view text);

}  // namespace tessera::exchange
