// The vehicle's bearing: the wheels tell how it changes, the compass where it lies (a complementary filter). Single
// samples that are far off do nothing; a compass that insists for a second is believed.
#pragma once

namespace tessera::firmware {

class Heading {
public:
  /// ratio: share of the compass per sample, 0 to 1 (wire::Parameter::CompassRatio).
  void configure(float ratio) { ratio_ = ratio; }

  /// The vehicle has turned by this much, radians counter-clockwise.
  void turn(float angle);
  /// A compass sample: bearing in radians. The first ones are averaged, so that the start is not left to one of them.
  /// Returns by how much it has turned the bearing, clockwise; 0 where the sample did nothing, or the start is made.
  float compass(float bearing);
  /// Starts from the next sample anew, as after a calibration.
  void restart() { samples_ = 0; }

  /// False until the first compass sample; the bearing then counts from where the vehicle stood at its start.
  [[nodiscard]] bool known() const { return known_; }
  /// Clockwise from north, in [-pi, pi].
  [[nodiscard]] float bearing() const { return bearing_; }

private:
  float ratio_ = 0.01F;
  float bearing_ = 0.0F;
  int samples_ = 0;
  int far_ = 0;
  bool known_ = false;
};

}  // namespace tessera::firmware
