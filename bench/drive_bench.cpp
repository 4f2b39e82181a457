// The controllers on a unicycle without radio delay: the table of docs/experiments.md. Nothing in it is left to chance.
#include <cstdio>
#include <string>

#include "drive/unicycle.h"

int main() {
  using namespace tessera;
  std::printf(
      "| turns, m | controller | finished | cross-track RMS, mm | largest, mm | time, s | RMS, ours to it | time, ours "
      "to it |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const double radius : {0.3, 0.5}) {
    const floor::Route route = test::roundedRoute(radius);
    const test::UnicycleRun ours = test::driveUnicycle(drive::followerNames().front(), route);
    for (const std::string_view name : drive::followerNames()) {
      const test::UnicycleRun run = test::driveUnicycle(name, route);
      std::printf("| %.1f | `%s` | %s | %.1f | %.1f | %.1f | %.2f | %.2f |\n", radius, std::string{name}.c_str(),
                  run.finished ? "yes" : "no", 1000 * run.crossTrackRms, 1000 * run.crossTrackMax, run.seconds,
                  ours.crossTrackRms / run.crossTrackRms, ours.seconds / run.seconds);
    }
  }
}
