// Strong types for physical quantities: a length is never mistaken for an angle, a speed never for a time.
// SI units throughout; value() leaves the type system and belongs inside function bodies only.
#pragma once

#include <compare>

namespace tessera {

/// A quantity in SI units that only mixes with its own kind. Tag names the dimension.
template <class Tag>
class Quantity {
public:
  constexpr Quantity() = default;
  constexpr explicit Quantity(double value) : value_{value} {}
  [[nodiscard]] constexpr double value() const { return value_; }

  constexpr auto operator<=>(const Quantity&) const = default;
  constexpr Quantity operator-() const { return Quantity{-value_}; }
  constexpr Quantity& operator+=(Quantity o) {
    value_ += o.value_;
    return *this;
  }
  constexpr Quantity& operator-=(Quantity o) {
    value_ -= o.value_;
    return *this;
  }
  constexpr Quantity& operator*=(double k) {
    value_ *= k;
    return *this;
  }
  friend constexpr Quantity operator+(Quantity a, Quantity b) { return Quantity{a.value_ + b.value_}; }
  friend constexpr Quantity operator-(Quantity a, Quantity b) { return Quantity{a.value_ - b.value_}; }
  friend constexpr Quantity operator*(Quantity a, double k) { return Quantity{a.value_ * k}; }
  friend constexpr Quantity operator*(double k, Quantity a) { return Quantity{a.value_ * k}; }
  friend constexpr Quantity operator/(Quantity a, double k) { return Quantity{a.value_ / k}; }
  friend constexpr double operator/(Quantity a, Quantity b) { return a.value_ / b.value_; }
  friend constexpr Quantity abs(Quantity a) { return a.value_ < 0 ? -a : a; }

private:
  double value_ = 0.0;
};

using Metres = Quantity<struct LengthTag>;
using Radians = Quantity<struct AngleTag>;
/// A span of time, or an instant counted from a start that its holder names (always the same one within a run).
using Seconds = Quantity<struct TimeTag>;
using MetresPerSecond = Quantity<struct SpeedTag>;
using RadiansPerSecond = Quantity<struct TurnRateTag>;
using MetresPerSecond2 = Quantity<struct AccelerationTag>;

constexpr Metres operator*(MetresPerSecond v, Seconds t) { return Metres{v.value() * t.value()}; }
constexpr Metres operator*(Seconds t, MetresPerSecond v) { return v * t; }
constexpr Radians operator*(RadiansPerSecond w, Seconds t) { return Radians{w.value() * t.value()}; }
constexpr MetresPerSecond operator*(MetresPerSecond2 a, Seconds t) { return MetresPerSecond{a.value() * t.value()}; }
constexpr MetresPerSecond operator/(Metres d, Seconds t) { return MetresPerSecond{d.value() / t.value()}; }
constexpr RadiansPerSecond operator/(Radians a, Seconds t) { return RadiansPerSecond{a.value() / t.value()}; }
constexpr Seconds operator/(Metres d, MetresPerSecond v) { return Seconds{d.value() / v.value()}; }
constexpr Seconds operator/(MetresPerSecond v, MetresPerSecond2 a) { return Seconds{v.value() / a.value()}; }

namespace literals {
constexpr Metres operator""_m(long double v) { return Metres{static_cast<double>(v)}; }
constexpr Metres operator""_cm(long double v) { return Metres{static_cast<double>(v) / 100.0}; }
constexpr Seconds operator""_s(long double v) { return Seconds{static_cast<double>(v)}; }
constexpr Seconds operator""_ms(long double v) { return Seconds{static_cast<double>(v) / 1000.0}; }
constexpr Radians operator""_rad(long double v) { return Radians{static_cast<double>(v)}; }
constexpr Radians operator""_deg(long double v) {
  return Radians{static_cast<double>(v) * 3.14159265358979323846 / 180.0};
}
constexpr MetresPerSecond operator""_mps(long double v) { return MetresPerSecond{static_cast<double>(v)}; }
}  // namespace literals

}  // namespace tessera
