#include "firmware/vehicle/command.h"

namespace tessera::firmware {

void Command::take(const wire::CycleEntry& entry, Micros now) {
  heard_ = now;
  switch (entry.mode) {
    case wire::CommandMode::Poll:
      break;
    case wire::CommandMode::Drive:
      kind_ = Kind::Drive;
      speed_ = static_cast<float>(entry.speed) * 1e-3F;
      bearing_ = wrapAngle(fromBinaryAngle(entry.bearing));
      until_ = now + std::chrono::milliseconds{entry.expiry * wire::kExpiryUnitMs};
      break;
    case wire::CommandMode::Stop:
    case wire::CommandMode::Clear:
      kind_ = Kind::Stand;
      break;
  }
}

Command::Kind Command::at(Micros now) {
  if (kind_ == Kind::Drive && now >= until_) kind_ = Kind::Expired;
  return kind_;
}

}  // namespace tessera::firmware
