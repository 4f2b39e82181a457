// The magnetic field that the vehicle's compass chip measures: the earth's, bent by spots of the floor, the vehicle's
// own hard and soft iron, a chip that is not mounted quite straight, and noise.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/pose.h"
#include "floor/site.h"
#include "sim/random_stream.h"

namespace tessera::sim {

/// A place where iron in or under the floor bends the earth's field: an added horizontal field of Gaussian shape.
struct MagneticSpot {
  Point centre;
  Metres radius;                 ///< standard deviation of the bump
  std::array<double, 2> peak{};  ///< µT along the site's x and y, at the centre
};

inline constexpr double kEarthHorizontal = 20.0;  ///< µT
/// Neighbouring spots bend to either side, which makes up to 20° between them: what was seen across a square metre of
/// a hall.
inline constexpr Radians kSpotDeviation = fromDegrees(10.0);

/// Spots spread over the site's floor, one for each 1.5 m² of its bounding box, by seed. `deviation` is the heading
/// error at a spot's centre when its field lies across the earth's.
[[nodiscard]] std::vector<MagneticSpot> seededSpots(const floor::Site& site, Radians deviation, std::uint64_t seed);

struct CompassParameters {
  double noise = 0.2;               ///< µT, standard deviation of one sample of one axis (HMC5883L: 2 mG)
  double hardIron = 60.0;           ///< µT, mean on x and y: also keeps all values positive, as QEMU's model needs
  double hardIronSpread = 5.0;      ///< µT, standard deviation by seed
  double softIron = 0.05;           ///< standard deviation of the soft iron matrix' entries by seed
  Radians bias = fromDegrees(2.0);  ///< the chip's x axis is turned by this from the nose; its sign comes by seed
};

class CompassField {
public:
  CompassField(const CompassParameters& parameters, Radians northToY, std::vector<MagneticSpot> spots,
               RandomStream random);

  /// µT along the chip's axes (x forward, y left, z up), with fresh noise.
  [[nodiscard]] std::array<double, 3> measure(const Pose& vehicle);
  /// µT along the site's axes, without the vehicle.
  [[nodiscard]] std::array<double, 2> atPlace(Point place) const;

private:
  CompassParameters parameters_;
  Radians northToY_;
  std::vector<MagneticSpot> spots_;
  RandomStream random_;
  Radians mounting_;
  std::array<double, 2> hardIron_{};
  std::array<double, 3> softIron_{};  ///< xx, xy = yx, yy: induced magnetism is symmetric
};

}  // namespace tessera::sim
