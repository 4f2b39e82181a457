// A vehicle, a radio's delay and a controller in one loop, without the simulated world: what the controller alone does.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "drive/route_follower.h"

namespace tessera::test {

struct LoopOptions {
  double speed = 0.12;            ///< m/s, asked for
  double up = 0.125;              ///< s from decision to effect
  double down = 0.125;            ///< s from measurement to decision
  double period = 0.1;            ///< s between decisions
  double jitter = 0.0;            ///< share by which the way up varies, unknown to the controller
  double poseNoise = 0.0;         ///< m, standard deviation, wandering with 1 s of memory, as an estimate's error does
  double headingNoise = 0.0;      ///< rad, likewise
  double gain = 3.0;              ///< 1/s, of the vehicle's heading hold (the controller believes in 3)
  double acceleration = 0.5;      ///< m/s² (the controller believes in 0.5)
  double cut = 0.0;               ///< m by which it may leave corners
  double lag = 0.10;              ///< s (the controller believes in 0.10)
  std::optional<Pose> start;      ///< else on the route's start, facing along it
  std::optional<double> carryAt;  ///< s: put down to the left by ...
  double carryBy = 0.6;           ///< ... so many m
  double limit = 240.0;           ///< s of driving at most
  std::uint32_t seed = 1;
};

struct LoopResult {
  bool finished = false;
  double duration = 0.0;
  double crossTrackRms = 0.0;  ///< of the true track, after the approach, from the route
  double crossTrackMax = 0.0;
  double largestLoss = 0.0;          ///< m by which the true progress fell below its best
  double endError = 0.0;             ///< m from the route's end when finished
  double cruise = 0.0;               ///< mean true speed farther than 0.25 m from every vertex
  double missedVertex = 0.0;         ///< m, the largest of the shortest distances from a vertex that it had
  double lowestSpeed = 1e9;          ///< m/s, true, from 15 cm behind the route's start to 15 cm before its end
  double lowestCommand = 0.0;        ///< m/s; negative would be backwards
  std::vector<double> topSpeeds;     ///< highest true speed on each leg, once it has left the start
  std::vector<drive::Phase> phases;  ///< in the order met
};

[[nodiscard]] floor::Route paperRoute();
[[nodiscard]] LoopResult closeLoop(std::string_view follower, const floor::Route& route, const LoopOptions& options);

}  // namespace tessera::test
