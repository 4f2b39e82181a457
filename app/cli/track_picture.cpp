#include "app/cli/track_picture.h"

#include <cstdio>

#include "ui/plot/track_plot.h"

namespace tessera::cli {
namespace {

std::vector<Point> outlineOf(const floor::Placement& placement, const floor::TileType& type) {
  const Radians turn{placement.quarterTurns * kPi / 2};
  std::vector<Point> outline;
  for (const Offset corner :
       {Offset{}, Offset{type.width, {}}, Offset{type.width, type.height}, Offset{{}, type.height}})
    outline.push_back(placement.origin + turned(corner, turn));
  return outline;
}

std::vector<std::vector<Point>> tilesOf(const floor::Site& site) {
  std::vector<std::vector<Point>> outlines;
  for (const auto& placement : site.placements) {
    for (const auto& tile : site.tiles) {
      if (tile.serial != placement.serial) continue;
      for (const auto& type : site.tileTypes) {
        if (type.name == tile.type) outlines.push_back(outlineOf(placement, type));
      }
    }
  }
  return outlines;
}

}  // namespace

Result<void> drawTracks(const floor::SiteMap& map, const std::vector<experiment::Outcome>& outcomes,
                        MetresPerSecond speed, std::uint64_t seed, const std::string& file) {
  ui::TrackPlot plot;
  char title[128];
  std::snprintf(title, sizeof title, "%s, %g m/s, seed %llu", map.site().name.c_str(), speed.value(),
                static_cast<unsigned long long>(seed));
  plot.title = title;
  plot.tiles = tilesOf(map.site());
  for (const auto& tag : map.tags()) plot.tags.push_back(tag.place);
  for (const auto& outcome : outcomes) {
    ui::TrackPlot::Track track;
    track.name = outcome.name;
    track.route = outcome.route;
    for (const auto& sample : outcome.samples) {
      if (!sample.belief.driving) continue;
      track.truth.push_back(sample.truth.pose.position);
      track.estimate.push_back(sample.belief.pose.position);
    }
    plot.tracks.push_back(std::move(track));
  }
  return ui::saveTrackPlot(plot, QString::fromStdString(file));
}

std::string sentenceOf(const experiment::Outcome& outcome) {
  const auto& m = outcome.metrics;
  if (m.samples == 0)
    return outcome.name + " never drove route " + outcome.assignment.route + ": there is nothing to measure.";
  char text[320];
  std::snprintf(text, sizeof text,
                "%s %s route %s in %.1f s: position error %.2f cm mean, %.2f cm p95; cross-track %.2f cm RMS, "
                "%.2f cm at most; turned back %d times; mean speed %.0f %% of what was asked, away from corners.",
                outcome.name.c_str(), outcome.finished ? "finished" : "did not finish",
                outcome.assignment.route.c_str(), m.duration.value(), 100 * m.positionErrorMean.value(),
                100 * m.positionErrorP95.value(), 100 * m.crossTrackRms.value(), 100 * m.crossTrackMax.value(),
                m.reversals, 100 * m.meanSpeedRatio);
  return text;
}

}  // namespace tessera::cli
