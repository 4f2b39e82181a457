// A picture of a drive: floor, route, true track and estimated track, as Figure 8 of the publication shows them.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "base/polyline.h"
#include "base/result.h"

namespace tessera::ui {

struct TrackPlot {
  struct Track {
    std::string name;
    Polyline route;
    std::vector<Point> truth;  ///< empty where the truth is not known
    std::vector<Point> estimate;
  };
  std::string title;
  std::vector<std::vector<Point>> tiles;  ///< outlines
  std::vector<Point> tags;
  std::vector<Track> tracks;
};

/// Draws to scale, lengths in centimetres, 900 pixels wide. Needs a QApplication (the offscreen platform will do).
/// Error: names the file that could not be written.
[[nodiscard]] Result<void> saveTrackPlot(const TrackPlot& plot, const QString& file);

}  // namespace tessera::ui
