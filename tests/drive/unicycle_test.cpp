// Our controller against Regulated Pure Pursuit, without radio, in the same run.
#include "drive/unicycle.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace tessera::test {
namespace {

UnicycleRun told(std::string_view follower, double radius) {
  const UnicycleRun run = driveUnicycle(follower, roundedRoute(radius));
  std::printf("%-24s turns of %.1f m: %s in %5.1f s, across rms %.1f max %.1f mm\n", std::string{follower}.c_str(),
              radius, run.finished ? "finished" : "NOT FINISHED", run.seconds, 1000 * run.crossTrackRms,
              1000 * run.crossTrackMax);
  return run;
}

TEST(Unicycle, isLedCloserAndSoonerThanByRegulatedPurePursuit) {
  for (const double radius : {0.3, 0.5}) {
    const UnicycleRun theirs = told("regulated-pure-pursuit", radius);
    const UnicycleRun ours = told("look-ahead", radius);
    ASSERT_TRUE(theirs.finished);
    ASSERT_TRUE(ours.finished);
    EXPECT_LE(ours.crossTrackRms, 0.6 * theirs.crossTrackRms);
    EXPECT_LE(ours.seconds, 0.85 * theirs.seconds);
    EXPECT_LT(theirs.crossTrackRms, 0.02) << "a fair opponent";
  }
}

}  // namespace
}  // namespace tessera::test
