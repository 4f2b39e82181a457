#include "firmware/vehicle/hmc5883l.h"

namespace tessera::firmware {
namespace {

constexpr std::uint8_t kRegisterA = 0;
constexpr std::uint8_t kRegisterB = 1;
constexpr std::uint8_t kMode = 2;
constexpr std::uint8_t kData = 3;
constexpr std::uint8_t kIdentification = 10;
constexpr std::uint8_t kAverage8At75Hz = 0x78;
constexpr std::uint8_t kContinuous = 0x00;
constexpr std::uint8_t kStandardGain = 1;
constexpr std::uint8_t kWidestGain = 7;
constexpr float kCountsPerGauss[] = {1370.0F, 1090.0F, 820.0F, 660.0F, 440.0F, 390.0F, 330.0F, 230.0F};
constexpr float kMicroteslaPerGauss = 100.0F;
constexpr std::int16_t kOverflow = -4096;
constexpr int kOverflowsToWiden = 3;
// At 75 Hz one conversion under the old gain can still lie in the registers at the next reading, at 50 Hz.
constexpr int kDropAfterGain = 2;
constexpr Micros kPeriod = 20ms;
constexpr Micros kRetry = 500ms;

std::int16_t bigEndian(std::uint8_t high, std::uint8_t low) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(high << 8 | low));
}

}  // namespace

bool Hmc5883l::set(std::uint8_t reg, std::uint8_t value) {
  const std::array<std::uint8_t, 2> out{reg, value};
  return board_.i2cWrite(kAddress, out);
}

bool Hmc5883l::get(std::uint8_t reg, std::span<std::uint8_t> out) {
  const std::array<std::uint8_t, 1> pointer{reg};
  return board_.i2cWrite(kAddress, pointer) && board_.i2cRead(kAddress, out);
}

bool Hmc5883l::configure() {
  std::array<std::uint8_t, 3> id{};
  if (!get(kIdentification, id) || id != std::array<std::uint8_t, 3>{'H', '4', '3'}) return false;
  gain_ = kStandardGain;
  overflows_ = 0;
  drop_ = kDropAfterGain;
  return set(kRegisterA, kAverage8At75Hz) && set(kRegisterB, static_cast<std::uint8_t>(gain_ << 5)) &&
         set(kMode, kContinuous);
}

void Hmc5883l::failed(Micros now) {
  if (failures_ < kFailuresToAbsent) ++failures_;
  if (absent()) running_ = false;
  next_ = now + (running_ || !absent() ? kPeriod : kRetry);
}

std::optional<Field> Hmc5883l::tick(Micros now) {
  if (now < next_) return std::nullopt;
  next_ = now + kPeriod;
  if (!running_) {
    running_ = configure();
    if (!running_) failed(now);
    return std::nullopt;
  }
  std::array<std::uint8_t, 6> raw{};
  if (!get(kData, raw)) {
    failed(now);
    return std::nullopt;
  }
  failures_ = 0;
  if (drop_ > 0) {
    --drop_;
    return std::nullopt;
  }
  return convert(raw);
}

std::optional<Field> Hmc5883l::convert(const std::array<std::uint8_t, 6>& raw) {
  const std::int16_t x = bigEndian(raw[0], raw[1]);
  const std::int16_t y = bigEndian(raw[4], raw[5]);
  if (x == kOverflow || y == kOverflow) {
    if (overflows_ < kOverflowsToWiden) ++overflows_;
    if (overflows_ == kOverflowsToWiden && gain_ < kWidestGain &&
        set(kRegisterB, static_cast<std::uint8_t>((gain_ + 1) << 5))) {
      ++gain_;
      drop_ = kDropAfterGain;
    }
    return std::nullopt;
  }
  overflows_ = 0;
  const float scale = kMicroteslaPerGauss / kCountsPerGauss[gain_];
  return Field{static_cast<float>(x) * scale, static_cast<float>(y) * scale};
}

}  // namespace tessera::firmware
