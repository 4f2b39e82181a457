// What the wheels say about the way: length and turn of each tick, and the sums that the host is told.
#pragma once

#include <cstdint>

namespace tessera::firmware {

class Odometry {
public:
  /// track: between the wheels' contact points, m.
  void configure(float track) { track_ = track; }
  /// Ways of the two wheels in this tick, m.
  void add(float left, float right) {
    turned_ = (right - left) / track_;
    way_ = 0.5F * (left + right);
    rest_ += 1000.0F * way_;
    const auto whole = static_cast<std::int32_t>(rest_);
    rest_ -= static_cast<float>(whole);
    travel_ = static_cast<std::uint16_t>(travel_ + whole);
  }
  /// Radians counter-clockwise, of the last tick.
  [[nodiscard]] float turned() const { return turned_; }
  /// m forwards, of the last tick.
  [[nodiscard]] float way() const { return way_; }
  /// mm, forwards minus backwards, modulo 65536.
  [[nodiscard]] std::uint16_t travel() const { return travel_; }

private:
  float track_ = 0.3F;
  float turned_ = 0.0F;
  float way_ = 0.0F;
  float rest_ = 0.0F;  ///< mm that make no whole one yet
  std::uint16_t travel_ = 0;
};

}  // namespace tessera::firmware
