// What hangs on the emulated chip's pins, as far as it is logic: the motor drivers behind the PWM, the encoders' two
// channels, the ultrasonic rangers.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "base/units.h"
#include "sim/qemu/trace_reader.h"

namespace tessera::sim {

/// Registers of PWM generator 1 as last written, and what duty they make of the two motors.
class MotorOutputs {
public:
  void write(const PwmWrite& w) {
    if (w.offset == 0x008) enable_ = w.value;
    if (w.offset == 0x080) running_ = (w.value & 1U) != 0;
    if (w.offset == 0x090) load_ = w.value;
    if (w.offset == 0x098) compare_[0] = w.value;
    if (w.offset == 0x09C) compare_[1] = w.value;
  }
  void setBackwards(std::size_t motor, bool backwards) { backwards_.at(motor) = backwards; }
  void reset() { *this = MotorOutputs{}; }
  /// -1000 to 1000: the share of the period in which the output is high, with the direction's sign.
  [[nodiscard]] int duty(std::size_t motor) const {
    const bool on = running_ && (enable_ & (motor == 0 ? 1U << 2 : 1U << 3)) != 0;
    if (!on || compare_.at(motor) >= load_) return 0;
    const std::uint32_t high = load_ - compare_.at(motor);
    const std::uint32_t period = load_ + 1;
    const int permille = static_cast<int>((high * 1000ULL + period / 2) / period);
    return backwards_.at(motor) ? -permille : permille;
  }

private:
  std::uint32_t enable_ = 0;
  bool running_ = false;
  std::uint32_t load_ = 0;
  std::array<std::uint32_t, 2> compare_{};
  std::array<bool, 2> backwards_{};
};

/// Levels of an encoder's channels (A | B << 1) at a count; neighbouring counts differ in one channel.
[[nodiscard]] constexpr unsigned encoderLevels(std::int64_t count) {
  constexpr std::array<unsigned, 4> kGray = {0b00, 0b01, 0b11, 0b10};
  return kGray[static_cast<std::size_t>(count & 3)];
}

/// An HC-SR04: the echo begins a fixed time after the trigger's end and lasts 58 µs per centimetre (its data sheet);
/// with nothing within 4 m it ends by itself. A dead one (NaN) gives none. A trigger during a pulse is ignored.
class EchoSource {
public:
  static constexpr Seconds kBurst{450e-6};
  static constexpr Metres kReach{4.0};
  static constexpr Seconds kOpen{38e-3};
  [[nodiscard]] static constexpr Seconds lengthOf(Metres range) {
    return range.value() <= 0 || range > kReach ? kOpen : Seconds{range.value() * 5800e-6};
  }

  void triggerFell(Seconds now, Metres range) {
    if (edge_ || std::isnan(range.value())) return;
    edge_ = now + kBurst;
    length_ = lengthOf(range);
  }
  /// When the pin is to change next.
  [[nodiscard]] std::optional<Seconds> nextEdge() const { return edge_; }
  [[nodiscard]] bool high() const { return high_; }
  /// The level the pin takes at its next edge.
  [[nodiscard]] bool nextLevel() const { return !high_; }
  /// The pin has changed at `now`: a rise that came late moves the fall by as much.
  void changed(Seconds now) {
    high_ = !high_;
    if (high_)
      edge_ = now + length_;
    else
      edge_.reset();
  }
  void reset() { *this = EchoSource{}; }

private:
  std::optional<Seconds> edge_;
  Seconds length_{};
  bool high_ = false;
};

}  // namespace tessera::sim
