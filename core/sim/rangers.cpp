#include "sim/rangers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tessera::sim {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();
constexpr int kRays = 5;  // across the cone: its width at 0.5 m is 20 cm, so posts of 5 cm are not missed there

double cross(Offset a, Offset b) { return a.x.value() * b.y.value() - a.y.value() * b.x.value(); }
double dot(Offset a, Offset b) { return a.x.value() * b.x.value() + a.y.value() * b.y.value(); }

double alongRay(Point eye, Offset ray, const Wall& wall) {
  const Offset edge = wall.to - wall.from;
  const Offset start = wall.from - eye;
  const double turn = cross(ray, edge);
  if (turn == 0.0) return kNothing;
  const double away = cross(start, edge) / turn;
  const double along = cross(start, ray) / turn;
  return away >= 0.0 && along >= 0.0 && along <= 1.0 ? away : kNothing;
}

double alongRay(Point eye, Offset ray, const Post& post) {
  const Offset centre = post.centre - eye;
  const double nearest = dot(centre, ray);
  const double radius = post.radius.value();
  const double gap = dot(centre, centre) - nearest * nearest;
  if (dot(centre, centre) <= radius * radius) return 0.0;
  if (nearest < 0.0 || gap > radius * radius) return kNothing;
  return nearest - std::sqrt(radius * radius - gap);
}

}  // namespace

double Rangers::nearestIn(const Scene& scene, Point eye, Radians heading) const {
  double nearest = kNothing;
  for (int i = 0; i < kRays; ++i) {
    const double share = 2.0 * i / (kRays - 1) - 1.0;
    const Offset ray = turned({Metres{1.0}, Metres{}}, heading + share * parameters_.halfCone);
    for (const Wall& wall : scene.walls) nearest = std::min(nearest, alongRay(eye, ray, wall));
    for (const Post& post : scene.posts) nearest = std::min(nearest, alongRay(eye, ray, post));
  }
  return nearest;
}

std::array<Metres, firmware::kRangers> Rangers::measure(const Pose& vehicle, const Scene& scene) {
  std::array<Metres, firmware::kRangers> ranges{};
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const double seen = nearestIn(scene, placeOf(vehicle, parameters_.places[i]), vehicle.heading);
    const double noise = random_.normal(parameters_.noise.value());
    const bool missed = random_.chance(parameters_.miss);
    if (dead_[i]) {
      ranges[i] = Metres{std::numeric_limits<double>::quiet_NaN()};
      continue;
    }
    if (missed || seen > parameters_.farthest.value()) continue;
    ranges[i] = std::max(parameters_.nearest, Metres{seen + noise});
  }
  return ranges;
}

}  // namespace tessera::sim
