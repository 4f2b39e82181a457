// The table runs.csv that bench/experiments.py leaves: the figures of many runs, and where each run lies.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace tessera::cli {

/// One run of one vehicle.
struct RunLine {
  std::string track;   ///< path of its track.csv
  std::string series;  ///< what it says in the column by which runs are told apart; "readers = 3", "5 cm/s" where that
                       ///< is a number
  double speed = 0.0;  ///< asked for, m/s
  double positionError = 0.0;  ///< mean, m
  double crossTrack = 0.0;     ///< RMS, m
  double reversals = 0.0;
  double neesMean = 0.0, neesLow = 0.0, neesHigh = 0.0;
};

struct RunTable {
  std::vector<RunLine> runs;
  std::size_t leftOut = 0;  ///< runs that gave no figures
};

/// by: the column that tells series apart. Error: names the file and the column or line: it cannot be read or is no
/// CSV, a column is missing, a figure is no finite number, no run gave figures.
[[nodiscard]] Result<RunTable> readRuns(const std::string& file, const std::string& by);

/// Position errors of a run in m, of the ticks that its figures count. Error: as above.
[[nodiscard]] Result<std::vector<double>> readErrors(const std::string& track);

}  // namespace tessera::cli
