// What the floor's iron will do to the particles' bias.
#include <cmath>

#include "locate/particle_locator.h"

namespace tessera::locate {

void ParticleLocator::foresee(CloudStep& step, Eigen::Vector2d& place) {
  const double heading = step.heading - moments_.mean(2);
  place += step.chord * moments_.mean(3) * Eigen::Vector2d{std::cos(heading), std::sin(heading)};
  const auto expected = foresight_.over(outlook_, {Metres{place.x()}, Metres{place.y()}}, step.way, step.seconds,
                                        options_.biasPerRootMetre);
  step.calm = expected.wander / options_.biasPerRootMetre;
  step.shift = expected.shift;
  step.pull = expected.pull;
  step.toward = expected.toward;
}

}  // namespace tessera::locate
