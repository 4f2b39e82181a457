// What stands in the vehicle's way, and the two ultrasonic rangers at its front corners that see it.
#pragma once

#include <array>
#include <vector>

#include "base/pose.h"
#include "firmware/vehicle/board.h"
#include "sim/random_stream.h"

namespace tessera::sim {

struct Wall {
  Point from;
  Point to;
};

/// A post, a person's legs, another vehicle.
struct Post {
  Point centre;
  Metres radius;
};

/// Everything that reflects sound.
struct Scene {
  std::vector<Wall> walls;
  std::vector<Post> posts;
};

struct RangerParameters {
  std::array<Offset, firmware::kRangers> places{Offset{Metres{0.20}, Metres{0.12}},
                                                Offset{Metres{0.20}, Metres{-0.12}}};
  Radians halfCone = fromDegrees(12.0);  ///< HC-SR04: 15° are nominal, the rim answers weakly
  Metres nearest{0.02};                  ///< what is nearer reads as this
  Metres farthest{4.0};
  Metres noise{0.003};
  double miss = 0.01;  ///< share of pings without echo
};

class Rangers {
public:
  Rangers(const RangerParameters& parameters, RandomStream random) : parameters_{parameters}, random_{random} {}

  /// Its cable is pulled, or put back.
  void setDead(std::size_t ranger, bool dead) { dead_.at(ranger) = dead; }

  /// Distance that each ranger would measure now, as in Signals::range: 0 for no echo, NaN for a dead one.
  [[nodiscard]] std::array<Metres, firmware::kRangers> measure(const Pose& vehicle, const Scene& scene);

private:
  [[nodiscard]] double nearestIn(const Scene& scene, Point eye, Radians heading) const;

  RangerParameters parameters_;
  RandomStream random_;
  std::array<bool, firmware::kRangers> dead_{};
};

}  // namespace tessera::sim
