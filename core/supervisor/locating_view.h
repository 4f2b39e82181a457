// How one vehicle is located just now, in every detail: filled only for the vehicle that somebody looks at (order
// Watch), so that the others' ticks cost nothing more.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/ids.h"
#include "base/pose.h"
#include "locate/innovation.h"
#include "locate/observation.h"

namespace tessera::supervisor {

struct LocatingView {
  static constexpr std::size_t kGuesses = 200;
  static constexpr std::size_t kInnovations = 16;
  static constexpr std::size_t kWay = 8;

  VehicleId vehicle;
  std::string locator;    ///< its name
  locate::Motion motion;  ///< the last report's
  // As of that report.
  Seconds at;
  Pose estimate;
  std::array<double, 9> covariance{};  ///< of x, y (m) and heading (rad), row by row
  bool located = false;
  std::vector<Point> guesses;  ///< places thought possible, kGuesses at most; empty: the locator has none
  // What the controller reckons with.
  std::vector<Pose> way;     ///< from the estimate to `predicted`, through the commands under way
  Pose predicted;            ///< when a command that is sent now takes effect
  Seconds effectiveAt;       ///< that instant
  Seconds hold;              ///< how long that command holds at least: until the next one comes
  std::optional<Point> aim;  ///< the point on the route that it is led to; nullopt: it follows none
  // Reads since the vehicle is watched, oldest first, kInnovations at most.
  std::vector<locate::Innovation> innovations;
  locate::LocatorCounters counters;

  /// Between the picture that is known and the instant for which is decided.
  [[nodiscard]] Seconds delay() const { return effectiveAt - at; }
};

}  // namespace tessera::supervisor
