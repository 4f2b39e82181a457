// From the chip's field to a bearing: the vehicle's own iron removed (an offset for hard, a 2 x 2 matrix for soft
// iron), the mounting and the declination added, and a look at whether the field can be the earth's at all.
#pragma once

#include <optional>

#include "firmware/vehicle/hmc5883l.h"
#include "firmware/vehicle/settings.h"

namespace tessera::firmware {

/// corrected = matrix * (measured - offset). Offset in µT.
struct CompassCorrection {
  float offsetX = 0.0F;
  float offsetY = 0.0F;
  float xx = 1.0F;
  float xy = 0.0F;
  float yx = 0.0F;
  float yy = 1.0F;
  [[nodiscard]] Field apply(Field measured) const;
};
[[nodiscard]] CompassCorrection correctionFrom(const Settings& settings);
/// False when a number is beyond its parameter's range; the settings may then be changed in part.
bool keepCorrection(const CompassCorrection& correction, Settings& settings);

/// Horizontal strengths that can be the earth's, µT: 20 to 42 between the polar circles; less or more, and iron near
/// the vehicle outweighs it.
inline constexpr float kWeakestField = 10.0F;
inline constexpr float kStrongestField = 60.0F;

class Compass {
public:
  struct Sample {
    Field raw;
    float bearing = 0.0F;  ///< of the nose, clockwise from true north, radians in [-pi, pi]
    bool usable = false;   ///< strength within kWeakestField .. kStrongestField
  };

  explicit Compass(Board& board) : chip_{board} {}
  void configure(const Settings& settings);
  /// To be called every tick; 50 samples a second.
  std::optional<Sample> tick(Micros now);

  [[nodiscard]] bool absent() const { return chip_.absent(); }
  /// Overflowing, or five samples running with an impossible strength.
  [[nodiscard]] bool outOfRange() const { return chip_.overflowed() || strange_ >= kStrangeToFault; }

private:
  static constexpr int kStrangeToFault = 5;
  Hmc5883l chip_;
  CompassCorrection correction_;
  float turn_ = 0.0F;  ///< declination minus mounting
  int strange_ = 0;
};

}  // namespace tessera::firmware
