// The figures by which a run is judged. All compare the true vehicle with the route or with the estimate for the same
// instant; the point meant is always the middle between the driven wheels.
#pragma once

#include <vector>

#include "app/experiment/consistency.h"
#include "app/experiment/samples.h"
#include "base/polyline.h"

namespace tessera::experiment {

struct Metrics {
  Metres positionErrorMean;  ///< |estimate - truth|, over every tick that is judged (Belief::driving)
  Metres positionErrorP95;
  Metres positionErrorMax;  ///< of the judged ticks from the first on at which it was located
  Radians headingErrorRms;
  Metres crossTrackRms;  ///< true distance from the route, corners included
  Metres crossTrackMax;
  Metres crossTrackRmsOffCorners;  ///< the same, at least `cornerMargin` away from every vertex
  Metres crossTrackMaxOffCorners;
  int reversals = 0;          ///< times that the true progress along the route fell by more than 2 cm
  double meanSpeedRatio = 0;  ///< true mean speed over the speed asked, `cornerMargin` away from vertices and ends
  Seconds duration;           ///< from the first judged tick to the last
  Metres endError;            ///< from the true last place to the route's end
  Consistency consistency;    ///< of the ticks at which it was located
  double locatedShare = 0;    ///< ticks at which the locator called the vehicle located
  std::size_t samples = 0;
};

inline constexpr Metres kReversal{0.02};
inline constexpr Metres kCornerMargin{0.20};

/// Only samples whose belief is `driving` count. An empty run gives zeros.
[[nodiscard]] Metrics evaluate(const Polyline& route, const std::vector<Sample>& samples, MetresPerSecond asked,
                               Metres cornerMargin = kCornerMargin);

/// Progress of a true track along the route, windowed so that a near leg is not taken for the present one.
class ProgressTracker {
public:
  explicit ProgressTracker(const Polyline& route) : route_{route} {}
  [[nodiscard]] Polyline::Projection update(Point truth);

private:
  const Polyline& route_;
  Metres along_;
};

}  // namespace tessera::experiment
