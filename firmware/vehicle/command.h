// The command in force, and until when. A vehicle whose commands stop coming stops by itself.
#pragma once

#include "firmware/vehicle/angles.h"
#include "firmware/vehicle/time.h"
#include "wire/messages.h"

namespace tessera::firmware {

class Command {
public:
  enum class Kind : std::uint8_t { Stand, Drive, Expired };

  /// A genuine entry that came at `now`. Poll changes nothing.
  void take(const wire::CycleEntry& entry, Micros now);
  /// What is in force at `now`.
  Kind at(Micros now);

  /// Of the Drive in force: m/s, and radians clockwise from north.
  [[nodiscard]] float speed() const { return speed_; }
  [[nodiscard]] float bearing() const { return bearing_; }
  /// When the host last said anything to this vehicle, a Poll included.
  [[nodiscard]] Micros lastHeard() const { return heard_; }

private:
  Kind kind_ = Kind::Stand;
  float speed_ = 0.0F;
  float bearing_ = 0.0F;
  Micros until_{0};
  Micros heard_{0};
};

}  // namespace tessera::firmware
