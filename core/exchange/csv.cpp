#include "exchange/csv.h"

namespace tessera::exchange {
namespace {

constexpr std::size_t kMostCsv = std::size_t{64} << 20;

class CsvReader {
public:
  CsvReader(std::string_view text, const std::string& name) : text_{text}, name_{name} {}

  Result<std::vector<CsvRow>> rows() {
    std::vector<CsvRow> rows;
    while (here_ < text_.size()) {
      CsvRow row{line_, {}};
      if (auto read = readRow(row); !read) return tl::unexpected{std::move(read.error())};
      if (row.fields.size() == 1 && row.fields[0].empty()) continue;
      if (!rows.empty() && row.fields.size() != rows.front().fields.size())
        return at(row.line, phrase("Core", "expected %1 fields as in the first line, found %2.")
                                .with(rows.front().fields.size(), row.fields.size()));
      rows.push_back(std::move(row));
    }
    return rows;
  }

private:
  [[nodiscard]] tl::unexpected<Error> at(std::size_t line, const Sentence& what) const {
    return failure(phrase("Core", "%1: line %2: %3").with(name_, line, what));
  }
  [[nodiscard]] bool lineEnds() const {
    return here_ == text_.size() || text_[here_] == '\n' || text_.substr(here_, 2) == "\r\n";
  }

  Result<void> readRow(CsvRow& row) {
    for (;;) {
      std::string& field = row.fields.emplace_back();
      if (here_ < text_.size() && text_[here_] == '"') {
        if (auto read = readQuoted(field); !read) return read;
      } else {
        while (!lineEnds() && text_[here_] != ',') {
          if (text_[here_] == '"') return at(line_, phrase("Core", "expected quotes only around a whole field."));
          field += text_[here_++];
        }
      }
      if (lineEnds()) break;
      ++here_;  // the comma
    }
    if (here_ < text_.size()) here_ += text_[here_] == '\r' ? 2 : 1;
    ++line_;
    return {};
  }

  Result<void> readQuoted(std::string& field) {
    const std::size_t began = line_;
    for (++here_;; ++here_) {
      if (here_ == text_.size())
        return at(began, phrase("Core", "expected a closing quote, found the end of the file."));
      if (text_[here_] == '"') {
        if (text_.substr(here_, 2) != "\"\"") break;
        ++here_;
      }
      if (text_[here_] == '\n') ++line_;
      field += text_[here_];
    }
    ++here_;
    if (!lineEnds() && text_[here_] != ',')
      return at(line_, phrase("Core", "expected a comma after the closing quote."));
    return {};
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t here_ = 0;
  std::size_t line_ = 1;
};

}  // namespace

Result<std::vector<CsvRow>> parseCsv(std::string_view text, const std::string& name) {
  if (text.size() > kMostCsv)
    return failure(
        phrase("Core", "%1: expected %2 of at most 64 MiB, found more.").with(name, phrase("Core", "a table")));
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return CsvReader{text, name}.rows();
}

std::string csvField(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos && !text.empty()) return std::string{text};
  if (text.empty()) return {};
  std::string s{"\""};
  for (const char c : text) s += c == '"' ? std::string{"\"\""} : std::string(1, c);
  return s + "\"";
}

}  // namespace tessera::exchange
