// Calibrates the compass: the vehicle turns on the spot, a little more than once to the left and as far back, which
// leaves it as it stood; what the compass showed meanwhile must lie on an ellipse.
#pragma once

#include <array>
#include <optional>

#include "firmware/vehicle/ellipse_fit.h"
#include "firmware/vehicle/time.h"

namespace tessera::firmware {

class CompassCalibration {
public:
  enum class Status : std::uint8_t { Idle, Turning, Done, Failed };

  void start(Micros now);
  void abort();

  /// One tick: `turned` is what the wheels turned the vehicle by, radians counter-clockwise; `field` a sample, if there
  /// is one. Fails when it takes longer than a minute, or when coverage, strength, shape or fit are poor.
  Status tick(float turned, std::optional<Field> field, Micros now);
  /// Turn rate that is wanted now, rad/s, counter-clockwise.
  [[nodiscard]] float turnRate() const;

  [[nodiscard]] Status status() const { return status_; }
  /// Mean field of what was measured in one of kBins directions since the start, by what the wheels have turned;
  /// nullopt: nothing. The turn begins with direction kBins / 2.
  [[nodiscard]] std::optional<Field> sample(std::size_t direction) const;
  /// The result, when Done.
  [[nodiscard]] const CompassCorrection& correction() const { return correction_; }

  static constexpr std::size_t kBins = 64;

private:
  struct Bin {
    float x = 0.0F;
    float y = 0.0F;
    int count = 0;
  };
  void add(Field field);
  void finish();

  Status status_ = Status::Idle;
  Micros started_{0};
  float angle_ = 0.0F;  ///< turned since the start
  bool back_ = false;   ///< on the way back
  std::array<Bin, kBins> bins_{};
  CompassCorrection correction_;
};

}  // namespace tessera::firmware
