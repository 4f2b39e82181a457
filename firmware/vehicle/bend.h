// What the vehicle turns beside what its wheels' encoders tell: tyres of unequal size, or worn or pressed unequally,
// lead it along a bend although both wheels turn alike. The integral beside the complementary filter's proportion
// (Mahony, Hamel, Pflimlin, "Nonlinear complementary filters on the special orthogonal group", IEEE TAC 53(5), 2008),
// taken along the way instead of over time, as tyres bend the way.
//
// Iron in the floor looks like a bend to it, until it is behind: what the compass takes back there is taken back here.
// So at any time iron that turns the compass by an angle a has put at most a / length into what was learned, at any
// speed; what is not above that is not believed (a dead zone, as in Peterson, Narendra, "Bounded error adaptive
// control", IEEE TAC 27(6), 1982).
#pragma once

namespace tessera::firmware {

class Bend {
public:
  /// length: way along which a bend is learned to 63 %, m, 0 learns nothing and forgets (Parameter::HeadingLearning).
  /// track: between the wheels, m.
  void configure(float length, float track);

  /// The vehicle has gone this way since the last call, m, backwards negative, and the compass has turned its bearing
  /// by `correction` radians clockwise (Heading::compass). To be called while it drives, not while it turns on the
  /// spot.
  void learn(float way, float correction);

  /// rad counter-clockwise for each metre forwards, as far as it is believed: 0 up to what iron may have put in, all
  /// of it from twice that on.
  [[nodiscard]] float perMetre() const { return believed_; }
  /// The same, believed or not.
  [[nodiscard]] float learned() const { return learned_; }

private:
  float length_ = 0.0F;
  float most_ = 0.0F;     ///< rad/m
  float doubt_ = 0.0F;    ///< rad/m that iron may put in
  float way_ = 0.0F;      ///< m since it last learned
  float turned_ = 0.0F;   ///< rad clockwise, by the compass, over that way
  float learned_ = 0.0F;  ///< rad/m
  float believed_ = 0.0F;
};

}  // namespace tessera::firmware
