// A drive over the floor as a locator sees it: noisy motion, tag events by the vehicle's rules, both late. Independent
// of the simulated world, so that locator and world cannot share a mistake.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "floor/site_map.h"
#include "locate/locator.h"

namespace tessera::test {

struct DriveOptions {
  double speed = 0.12;        ///< m/s
  double detection = 0.9;     ///< per attempt
  double pollPeriod = 0.1;    ///< s
  double reportPeriod = 0.2;  ///< s
  double delay = 0.2;         ///< s, from the report's making to the locator
  double compassNoise = 2.0;  ///< degrees, white, per report
  double compassBias = 2.0;   ///< degrees
  /// Radians by which iron turns the compass at a place; the heading follows it as slowly as a vehicle's. Null: none.
  std::function<double(Point)> iron = nullptr;
  double speedNoise = 0.10;  ///< share, of a slowly wandering kind (1 s)
  double lostEvents = 0.0;   ///< chance that a tag event never arrives
  double unknownTags = 0.0;  ///< chance that a tag's UID is not in the map
  std::optional<double>
      carriedAt;             ///< s: lifted and set down 0.5 m to the right (or left, near the edge), turned by 90°
  bool shuffled = false;     ///< each report's observations in reverse order, every third report 1 s late
  bool silenceLast = false;  ///< the silence before a read is told after it, with the rest of the report's
  bool everyRead = false;    ///< every successful attempt is told, not only the first of a visit
  std::uint32_t seed = 1;
};

struct Sample {
  double at;
  Pose truth;
  locate::Estimate estimate;  ///< for the instant of the last motion known
};

/// Drives the polyline (turning on the spot at its vertices) and returns a sample per report delivered.
[[nodiscard]] std::vector<Sample> drive(const floor::SiteMap& map, const floor::VehicleSetup& vehicle,
                                        const std::vector<Point>& vertices, const DriveOptions& options,
                                        locate::Locator& locator);

struct ErrorSummary {
  double mean = 0.0;
  double p95 = 0.0;
  double headingRms = 0.0;
  double locatedShare = 0.0;
};
/// Of the samples between two instants.
[[nodiscard]] ErrorSummary summarise(const std::vector<Sample>& samples, double from = 0.0, double to = 1e9);

}  // namespace tessera::test
