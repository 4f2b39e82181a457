// Charts over many runs of an experiment: how position errors are spread, figures against speed, honesty of claims.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "base/result.h"

namespace tessera::ui {

/// Values of one kind under one name, e.g. of one controller.
struct ErrorSeries {
  std::string name;
  std::vector<double> errors;  ///< cm, at least one, finite
};

/// A figure at one speed, over the runs at it.
struct AtSpeed {
  double speed = 0.0;  ///< cm/s
  double mean = 0.0;
  double low = 0.0;  ///< of the runs
  double high = 0.0;
};
struct SpeedSeries {
  std::string name;
  std::vector<AtSpeed> points;  ///< in the order of speed
};
struct SpeedPanel {
  std::string label;  ///< of the vertical axis, with its unit
  std::vector<SpeedSeries> series;
};

/// The mean NEES of a run, and the bounds in which it lies in 95 of 100 runs of an honest locator.
struct RunHonesty {
  double mean = 0.0;
  double low = 0.0;
  double high = 0.0;
  bool operator==(const RunHonesty&) const = default;
};
struct HonestySeries {
  std::string name;
  std::vector<RunHonesty> runs;
};

// All are 900 pixels wide, on white. They need a QApplication (the offscreen platform will do). Error: names the file
// that could not be written.

/// A histogram; the legend says mean, 95th percentile and largest of each series.
[[nodiscard]] Result<void> saveErrorChart(const std::string& title, const std::vector<ErrorSeries>& series,
                                          const QString& file);

/// Panels above each other over one axis of speeds. The same series of each panel must have the same name: the legend
/// names those of the first.
[[nodiscard]] Result<void> saveSpeedChart(const std::string& title, const std::vector<SpeedPanel>& panels,
                                          const QString& file);

/// A mark a run within its bounds, runs of a series beside each other; those outside are marked otherwise.
[[nodiscard]] Result<void> saveHonestyChart(const std::string& title, const std::vector<HonestySeries>& series,
                                            const QString& file);

}  // namespace tessera::ui
