#include "firmware/vehicle/compass.h"

#include "firmware/vehicle/angles.h"

namespace tessera::firmware {
namespace {

using wire::Parameter;

constexpr float kNanotesla = 0.001F;
constexpr float kTenThousandth = 0.0001F;

float scaled(const Settings& s, Parameter p, float unit) { return static_cast<float>(s.get(p)) * unit; }

bool keep(Settings& s, Parameter p, float value, float unit) {
  const float number = value / unit;
  if (!(std::fabs(number) < 1e6F)) return false;  // also false for a NaN
  return s.set(p, static_cast<std::int32_t>(std::lround(number))) == wire::Outcome::Done;
}

}  // namespace

Field CompassCorrection::apply(Field measured) const {
  const float x = measured.x - offsetX;
  const float y = measured.y - offsetY;
  return {xx * x + xy * y, yx * x + yy * y};
}

CompassCorrection correctionFrom(const Settings& s) {
  return {scaled(s, Parameter::CompassOffsetX, kNanotesla),      scaled(s, Parameter::CompassOffsetY, kNanotesla),
          scaled(s, Parameter::CompassMatrixXX, kTenThousandth), scaled(s, Parameter::CompassMatrixXY, kTenThousandth),
          scaled(s, Parameter::CompassMatrixYX, kTenThousandth), scaled(s, Parameter::CompassMatrixYY, kTenThousandth)};
}

bool keepCorrection(const CompassCorrection& c, Settings& s) {
  return keep(s, Parameter::CompassOffsetX, c.offsetX, kNanotesla) &&
         keep(s, Parameter::CompassOffsetY, c.offsetY, kNanotesla) &&
         keep(s, Parameter::CompassMatrixXX, c.xx, kTenThousandth) &&
         keep(s, Parameter::CompassMatrixXY, c.xy, kTenThousandth) &&
         keep(s, Parameter::CompassMatrixYX, c.yx, kTenThousandth) &&
         keep(s, Parameter::CompassMatrixYY, c.yy, kTenThousandth);
}

void Compass::configure(const Settings& settings) {
  correction_ = correctionFrom(settings);
  turn_ = fromBinaryAngle(settings.get(Parameter::Declination) - settings.get(Parameter::CompassMounting));
}

// With the nose at bearing b and the chip's x axis m clockwise from it, north lies b + m counter-clockwise from that
// axis, i.e. towards +y.
std::optional<Compass::Sample> Compass::tick(Micros now) {
  const auto raw = chip_.tick(now);
  if (!raw) return std::nullopt;
  const Field field = correction_.apply(*raw);
  const float strength = std::sqrt(field.x * field.x + field.y * field.y);
  Sample sample;
  sample.raw = *raw;
  sample.usable = strength >= kWeakestField && strength <= kStrongestField;
  sample.bearing = wrapAngle(std::atan2(field.y, field.x) + turn_);
  if (sample.usable)
    strange_ = 0;
  else if (strange_ < kStrangeToFault)
    ++strange_;
  return sample;
}

}  // namespace tessera::firmware
