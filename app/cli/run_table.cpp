#include "app/cli/run_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>

#include "exchange/csv.h"
#include "floor/text_file.h"

namespace tessera::cli {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;

std::optional<double> numberIn(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

// A table whose columns are asked for by name.
class NamedTable {
public:
  static Result<NamedTable> read(const std::string& file) {
    auto text = floor::loadText(file, kMostBytes + 1);
    if (!text) return tl::unexpected{text.error()};
    auto rows = exchange::parseCsv(*text, file);
    if (!rows) return tl::unexpected{rows.error()};
    if (rows->empty()) return failure(file + " is empty.");
    return NamedTable{file, std::move(*rows)};
  }

  Result<std::size_t> column(const std::string& name) const {
    const auto& names = rows_.front().fields;
    const auto it = std::find(names.begin(), names.end(), name);
    if (it == names.end()) return failure(file_ + " has no column " + name + ".");
    return static_cast<std::size_t>(it - names.begin());
  }

  /// In the order of `names`.
  Result<std::vector<std::size_t>> columns(const std::vector<std::string>& names) const {
    std::vector<std::size_t> found;
    for (const std::string& name : names) {
      auto one = column(name);
      if (!one) return tl::unexpected{one.error()};
      found.push_back(*one);
    }
    return found;
  }

  Result<double> number(const exchange::CsvRow& row, std::size_t column) const {
    if (const auto value = numberIn(row.fields[column])) return *value;
    return failure(file_ + ": line " + std::to_string(row.line) + ": expected a number for " +
                   rows_.front().fields[column] + ", found \"" + row.fields[column] + "\".");
  }

  [[nodiscard]] std::span<const exchange::CsvRow> rows() const { return std::span{rows_}.subspan(1); }

private:
  NamedTable(std::string file, std::vector<exchange::CsvRow> rows) : file_{std::move(file)}, rows_{std::move(rows)} {}
  std::string file_;
  std::vector<exchange::CsvRow> rows_;
};

std::string seriesName(const std::string& by, const std::string& value) {
  const auto number = numberIn(value);
  if (!number) return value;
  if (by != "speed_m_per_s") return by + " = " + value;
  char text[40];
  std::snprintf(text, sizeof text, "%g cm/s", *number * 100.0);
  return text;
}

}  // namespace

Result<RunTable> readRuns(const std::string& file, const std::string& by) {
  const auto table = NamedTable::read(file);
  if (!table) return tl::unexpected{table.error()};
  const auto texts = table->columns({"folder", "track", by});
  if (!texts) return tl::unexpected{texts.error()};
  const auto figures = table->columns({"speed_m_per_s", "position_error_mean_m", "cross_track_rms_m", "reversals",
                                       "nees_mean", "nees_low", "nees_high"});
  if (!figures) return tl::unexpected{figures.error()};
  const auto error = table->column("error");  // only there where a run gave no figures
  RunTable found;
  for (const exchange::CsvRow& row : table->rows()) {
    if (error && !row.fields[*error].empty()) {
      ++found.leftOut;
      continue;
    }
    RunLine run;
    run.track =
        (std::filesystem::path{file}.parent_path() / row.fields[(*texts)[0]] / row.fields[(*texts)[1]]).string();
    run.series = seriesName(by, row.fields[(*texts)[2]]);
    double* const values[] = {&run.speed,    &run.positionError, &run.crossTrack, &run.reversals,
                              &run.neesMean, &run.neesLow,       &run.neesHigh};
    for (std::size_t i = 0; i < figures->size(); ++i) {
      const auto value = table->number(row, (*figures)[i]);
      if (!value) return tl::unexpected{value.error()};
      *values[i] = *value;
    }
    found.runs.push_back(std::move(run));
  }
  if (found.runs.empty()) return failure(file + " holds no run that gave figures.");
  return found;
}

Result<std::vector<double>> readErrors(const std::string& track) {
  const auto table = NamedTable::read(track);
  if (!table) return tl::unexpected{table.error()};
  const auto columns = table->columns({"judged", "true_x_m", "true_y_m", "estimate_x_m", "estimate_y_m"});
  if (!columns) return tl::unexpected{columns.error()};
  std::vector<double> errors;
  for (const exchange::CsvRow& row : table->rows()) {
    double values[5] = {};
    for (std::size_t i = 0; i < columns->size(); ++i) {
      const auto value = table->number(row, (*columns)[i]);
      if (!value) return tl::unexpected{value.error()};
      values[i] = *value;
    }
    if (values[0] != 0.0) errors.push_back(std::hypot(values[1] - values[3], values[2] - values[4]));
  }
  if (errors.empty()) return failure(track + " holds no tick that is judged.");
  return errors;
}

}  // namespace tessera::cli
