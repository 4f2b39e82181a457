// The vehicle's body: two driven wheels with motors that lag, rub and differ, tyres that slip, and the pose that
// follows. Integrated along exact arcs, so that the step length does not show in the path.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/pose.h"
#include "base/units.h"
#include "sim/random_stream.h"

namespace tessera::sim {

struct PlantParameters {
  Metres wheelDiameter{0.10};  ///< as the vehicle's settings say; the true ones differ by the scale errors below
  Metres track{0.30};
  int countsPerTurn = 200;
  Seconds motorLag{0.10};                 ///< time constant of a driven wheel; half of it when braking
  MetresPerSecond speedAtFullDuty{0.80};  ///< without friction, at the nominal voltage
  double nominalVolts = 12.0;             ///< duty acts in proportion to the battery's voltage
  MetresPerSecond friction{0.03};         ///< Coulomb friction, as speed lost
  MetresPerSecond deadBand{0.05};         ///< a wheel at rest starts only when driven harder than this
  double motorMismatch = 0.03;            ///< standard deviation of each motor's gain
  double scaleError = 0.01;               ///< standard deviation of both wheels' common diameter error
  double scaleDifference = 0.003;         ///< standard deviation of each wheel's own diameter error
  double tyreDifference = 0.0;            ///< right tyre larger than the left one by this share; encoders do not see it
  double slip = 0.0;                      ///< mean share of the way that the wheels turn without driving it
  double slipWander = 0.02;               ///< standard deviation of each wheel's slowly changing slip
  double speedNoise = 0.0;                ///< the same of both wheels together: a floor that gives way, wet tyres
  Seconds slipMemory{0.5};                ///< correlation time of each wheel's own
  Seconds speedNoiseMemory{0.5};          ///< and of what they have in common; 0.05 s: as good as white at 10 Hz
  double wayNoise = 0.003;                ///< m, standard deviation of each wheel's way after one metre
};

/// The pose after a way along an arc of constant curvature.
[[nodiscard]] Pose advancedAlongArc(const Pose& from, Metres way, Radians turn);

class Plant {
public:
  Plant(const PlantParameters& parameters, const Pose& start, RandomStream random);

  /// duty: left, right, -1000 to 1000; 0 brakes. volts: of the battery under this load.
  void step(Seconds dt, const std::array<int, 2>& duty, double volts);

  [[nodiscard]] const Pose& pose() const { return pose_; }
  /// Over the ground, slip included, the floor's small jolts (wayNoise) not.
  [[nodiscard]] MetresPerSecond speed() const { return speed_; }
  [[nodiscard]] RadiansPerSecond turnRate() const { return turnRate_; }
  /// Quadrature counts of the wheels' true rotation since the start.
  [[nodiscard]] std::array<std::int64_t, 2> encoderCounts() const;
  /// Angle that a wheel has turned by since the start, forwards positive.
  [[nodiscard]] Radians wheelAngle(std::size_t wheel) const { return Radians{wheels_.at(wheel).angle}; }
  [[nodiscard]] Metres trueDiameter(std::size_t wheel) const { return Metres{wheels_.at(wheel).diameter}; }

  /// Lifted and set down elsewhere: the wheels do not turn.
  void setPose(const Pose& pose) { pose_ = pose; }
  /// Jams a wheel (it stands at once) or frees it.
  void setBlocked(std::size_t wheel, bool blocked) { wheels_.at(wheel).blocked = blocked; }

private:
  struct Wheel {
    double gain = 1.0;
    double diameter = 0.0;
    double surfaceSpeed = 0.0;
    double angle = 0.0;
    double slip = 0.0;
    bool blocked = false;
  };
  void drive(Wheel& wheel, double dt, int duty, double volts) const;
  double groundSpeed(Wheel& wheel, double dt);
  void wander(double dt);

  PlantParameters parameters_;
  Pose pose_;
  RandomStream random_;
  std::array<Wheel, 2> wheels_;
  double commonSlip_ = 0.0;
  MetresPerSecond speed_;
  RadiansPerSecond turnRate_;
};

}  // namespace tessera::sim
